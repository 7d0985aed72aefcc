// The norm in which the map of a stable periodic motion contracts.
//
// With J the derivative of the map at its fixed point, |mu| < 1 its spectral radius and
// rho = (1 + |mu|) / 2,
//
//   |y|_S^2 = y^T S y,   S = sum over k of (J^T)^k J^k / rho^(2k)
//
// obeys |J y|_S <= rho |y|_S, since J^T S J = rho^2 (S - I): no eigenvectors are needed, so that
// defective multipliers are like any other.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::periodic {

class AdaptedNorm {
public:
  /// `by_state`: J, in entries that may be compared with each other, and its spectral radius.
  /// std::logic_error where that is not below one.
  AdaptedNorm(const Matrix &by_state, double multiplier);

  /// Asked for every period of a motion: a general product would cost more than a small one.
  double operator()(const Vector &y) const { return root_.transpose().lazyProduct(y).norm(); }
  /// |mu|
  double multiplier() const { return multiplier_; }
  /// rho
  double contraction() const { return 0.5 * (1 + multiplier_); }
  /// L of S = L L^T, lower triangular: y = L^-T u has |y|_S = |u|.
  const Matrix &root() const { return root_; }

private:
  double multiplier_;
  Matrix root_;
};

/// Largest absolute value of the eigenvalues; 0 without any.
double spectral_radius(const Matrix &a);

/// sum over k of (A^T)^k A^k for a matrix of spectral radius below one: S = I + A^T S A, by
/// doubling (Smith 1968).
Matrix discrete_lyapunov(const Matrix &a);

} // namespace vibroimpact::periodic
