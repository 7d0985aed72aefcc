// Gauss quadrature for weights that are powers at both ends of [0, 1].
//
//   integral of x^alpha (1 - x)^beta g(x) over [0, 1] = sum of weights g(nodes),
//
// exact for polynomials g of degree 2 count - 1. Nodes are the eigenvalues of the Jacobi matrix of
// the three-term recurrence (Golub and Welsch 1969), polished by Newton's method; weights are 1 /
// sum p_k^2 of the orthonormal polynomials p_k. In extended precision; 1 - x is carried along,
// since a power of it keeps only the digits that it has.
#pragma once

#include <Eigen/Core>

namespace vibroimpact::motion {

using LongArray = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

struct GaussRule {
  LongArray nodes;   ///< ascending, in (0, 1)
  LongArray rest;    ///< 1 - nodes
  LongArray weights; ///< > 0
};

/// The orthonormal polynomials of the weight x^alpha (1 - x)^beta on [0, 1], or of one like it.
class JacobiPolynomials {
public:
  /// alpha, beta > -1; degrees below `count`, which is at least 1.
  JacobiPolynomials(double alpha, double beta, int count);
  /// Of another weight, given by a rule that is exact for its products of polynomials of degree
  /// below `count`.
  JacobiPolynomials(const GaussRule &weight, int count);

  /// p_0 ... p_(count-1) at x.
  LongArray at(long double x) const;
  GaussRule rule() const;

private:
  long double correction(long double x) const;

  LongArray diagonal_; ///< of the Jacobi matrix
  LongArray beside_;   ///< entry k: between k and k + 1
  long double first_;  ///< p_0
};

} // namespace vibroimpact::motion
