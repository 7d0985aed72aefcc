// Approximate eigenvectors made accurate: inverse iteration with residuals from an accurate
// stiffness product, then a Rayleigh-Ritz step that respects the small eigenvalues.
#pragma once

#include "modes/factorisation.h"
#include "modes/vector_block.h"

namespace vibroimpact::modes {

/// K phi = lambda M phi. `accurate_stiffness` is the same operator as `stiffness` with less
/// round-off, or `stiffness` itself; only products are taken with it.
struct EigenProblem {
  Mat stiffness = nullptr;
  Mat mass = nullptr;
  Mat accurate_stiffness = nullptr;
  int mass_rank = 0; ///< number of finite eigenvalues
};

struct Eigenpairs {
  Vector values; ///< ascending
  Block vectors; ///< M-orthonormal
};

/// The best eigenpairs in the span of the columns of x.
Eigenpairs rayleigh_ritz(const EigenProblem &problem, Block x);

/// What inverse iteration changes, and how much there is to change.
struct Correction {
  Block step; ///< A^-1 (K x - M x Lambda) with A = K - shift M
  /// Upper bounds of |lambda - exact| / (exact - shift), one for each pair: with r = K x - lambda M
  /// x they are sqrt(r^T A^-1 r / x^T A x).
  Vector error_bounds;
};

/// x - step approximates the lowest eigenvectors better than x when the shift lies below the
/// spectrum. `shifted` is A.
Correction inverse_iteration(const EigenProblem &problem, const Factorisation &shifted,
                             double shift, const Eigenpairs &pairs);

/// max |X^T M X - I|
double orthogonality_residual(const EigenProblem &problem, const Block &x);

} // namespace vibroimpact::modes
