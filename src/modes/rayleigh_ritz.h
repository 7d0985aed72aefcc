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

/// One step x -= (K - shift M)^-1 (K x - M x Lambda) for all columns and a Rayleigh-Ritz step. The
/// shift lies below the spectrum, and the columns approximate the lowest eigenvectors.
Eigenpairs refine(const EigenProblem &problem, const Factorisation &shifted,
                  const Eigenpairs &pairs);

/// Upper bounds of |lambda - exact| / (exact - shift), one for each pair: with r = K x - lambda M x
/// and A = K - shift M they are sqrt(r^T A^-1 r / x^T A x).
Vector error_bounds(const EigenProblem &problem, const Factorisation &shifted, double shift,
                    const Eigenpairs &pairs);

/// max |X^T M X - I|
double orthogonality_residual(const EigenProblem &problem, const Block &x);

} // namespace vibroimpact::modes
