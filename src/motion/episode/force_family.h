// Forces between two instants as a power at each end times a polynomial.
//
// With x in [0, 1] the part of the step that is over, w = x^alpha (1 - x)^beta, a parameter xi of x
// (episode_time.h) and nodes xi_j of the Gauss rule of w dx/dxi,
//
//   f(x) = sum over j of f_j phi_j(x),   phi_j = (w / w_j) l_j(xi),
//
// l_j the Lagrange polynomials. The force of a contact F = k u^n between its first touch and its
// release is t^n times a series in t and t^(n+1) at both ends, so that alpha = beta = n with x = xi
// leaves a smooth quotient f / w: a dozen nodes carry it to ten digits. Where damping makes it
// begin with a root of the time, u^(1/2) u' say, f / w is a series in that root.
#pragma once

#include "common/linear_algebra.h"
#include "motion/episode/episode_time.h"
#include "motion/episode/gauss_jacobi.h"

namespace vibroimpact::motion {

/// Exponents at both ends, the roots of the time in which the rest is smooth, and how many nodes.
struct ForceShape {
  double begin = 0; ///< alpha > -1
  double end = 0;   ///< beta > -1
  int nodes = 0;
  int begin_root = 1; ///< p
  int end_root = 1;   ///< q

  auto operator<=>(const ForceShape &other) const = default;
};

class ForceFamily {
public:
  explicit ForceFamily(const ForceShape &shape);

  const ForceShape &shape() const { return shape_; }
  int size() const { return shape_.nodes; }
  const Vector &nodes() const { return nodes_; } ///< x_j
  /// In xi, with the weight w dx/dxi.
  const GaussRule &rule() const { return rule_; }
  const EpisodeTime &stretch() const { return stretch_; }
  /// l_j / w_j, and phi_j; xi in [0, 1], rest = 1 - xi.
  LongArray quotients(long double xi) const;
  LongArray functions(long double xi, long double rest) const;
  /// w at xi over the powers of xi and 1 - xi that it begins and ends with, times the same of
  /// dx/dxi; those powers.
  long double smooth_weight(long double xi, long double rest) const;
  double begin_power() const { return shape_.begin_root * (shape_.begin + 1) - 1; }
  double end_power() const { return shape_.end_root * (shape_.end + 1) - 1; }

  /// Part of f / w in its last two polynomials: the larger of their coefficients over the first, in
  /// the orthonormal polynomials of w. `forces`: size() values at the nodes.
  double tail(const double *forces) const { return tail(forces, forces); }
  /// The same of a component, over the whole.
  double tail(const double *forces, const double *whole) const;
  /// True when f / w is proven positive between the ends, by its Bernstein coefficients.
  /// `falls_to_zero`: it is zero at the end, which counts as positive.
  bool is_positive(const double *forces, bool falls_to_zero = false) const;

private:
  JacobiPolynomials polynomials() const;
  void set_coefficients();
  void set_bernstein();

  ForceShape shape_;
  EpisodeTime stretch_;
  GaussRule rule_;
  Vector nodes_;
  LongArray weights_;      ///< w_j
  LongArray denominators_; ///< of the Lagrange polynomials
  Matrix coefficients_;    ///< 3 x nodes: of the first and the last two orthonormal polynomials
  Matrix bernstein_;       ///< nodes x nodes: values f_j to Bernstein coefficients of f / w
};

} // namespace vibroimpact::motion
