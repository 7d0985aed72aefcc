// Forces between two instants as a power at each end times a polynomial.
//
// With x in [0, 1] the part of the step that is over, w = x^alpha (1 - x)^beta and nodes x_j of the
// Gauss rule of w,
//
//   f(x) = sum over j of f_j phi_j(x),   phi_j = (w / w_j) l_j,   l_j the Lagrange polynomials.
//
// The force of a contact F = k u^n between its first touch and its release is t^n times a series in
// t and t^(n+1) at both ends, so that alpha = beta = n leaves a smooth quotient f / w: a dozen
// nodes carry it to ten digits.
#pragma once

#include "common/linear_algebra.h"
#include "motion/collocation/gauss_jacobi.h"

namespace vibroimpact::motion {

/// Exponents at both ends, and how many nodes.
struct ForceShape {
  double begin = 0; ///< alpha > -1
  double end = 0;   ///< beta > -1
  int nodes = 0;

  auto operator<=>(const ForceShape &other) const = default;
};

class ForceFamily {
public:
  explicit ForceFamily(const ForceShape &shape);

  const ForceShape &shape() const { return shape_; }
  int size() const { return shape_.nodes; }
  const Vector &nodes() const { return nodes_; } ///< x_j
  const GaussRule &rule() const { return rule_; }
  /// l_j(x) / w_j, and phi_j(x); x in [0, 1], rest = 1 - x.
  LongArray quotients(long double x) const;
  LongArray functions(long double x, long double rest) const;

  /// Part of f / w in its last two polynomials: the larger of their coefficients over the first, in
  /// the orthonormal polynomials of w. `forces`: size() values at the nodes.
  double tail(const double *forces) const;
  /// True when f / w is proven positive between the ends, by its Bernstein coefficients.
  bool is_positive(const double *forces) const;

private:
  void set_coefficients();
  void set_bernstein();

  ForceShape shape_;
  GaussRule rule_;
  Vector nodes_;
  LongArray weights_;      ///< w_j
  LongArray denominators_; ///< of the Lagrange polynomials
  Matrix coefficients_;    ///< 3 x nodes: of the first and the last two orthonormal polynomials
  Matrix bernstein_;       ///< nodes x nodes: values f_j to Bernstein coefficients of f / w
};

} // namespace vibroimpact::motion
