// Approximate eigenvectors made accurate: inverse iteration with residuals from an accurate
// stiffness product, then a Rayleigh-Ritz step that respects the small eigenvalues.
#pragma once

#include "modes/factorisation.h"
#include "modes/vector_block.h"

#include <memory>

namespace vibroimpact::modes {

/// K phi = lambda M phi. `accurate_stiffness` is the same operator as `stiffness` with less
/// round-off, or `stiffness` itself; only products are taken with it.
struct EigenProblem {
  Mat stiffness = nullptr;
  Mat mass = nullptr;
  Mat accurate_stiffness = nullptr;
  int mass_rank = 0; ///< number of finite eigenvalues
  /// Standard deviation, relative, of the rounding of the entries of the stiffness; 0 where the
  /// accurate one has none to speak of.
  double entry_error = 0;
  /// Shared by the copies of this problem, so that modes, attachments and static solutions have one
  /// order of elimination and its memory, and solutions with the same shift one factorisation.
  std::shared_ptr<FactorisedPencil> factorised = std::make_shared<FactorisedPencil>();

  const Factorisation &factorised_at(double shift) const {
    return factorised->at(stiffness, mass, shift);
  }
};

struct Eigenpairs {
  Vector values; ///< ascending
  Block vectors; ///< M-orthonormal
};

/// The best eigenpairs in the span of the columns of x.
Eigenpairs rayleigh_ritz(const EigenProblem &problem, Block x);

/// What inverse iteration changes, and how much there is to change.
struct Correction {
  Block step;               ///< A^-1 R with R = K x - M x Lambda and A = K - shift M
  Matrix residual_products; ///< R^T A^-1 R, on every rank
};

/// x - step approximates the lowest eigenvectors better than x when the shift of `shifted` lies
/// below the spectrum. Collective.
Correction inverse_iteration(const EigenProblem &problem, const Factorisation &shifted,
                             const Eigenpairs &pairs);

/// Standard deviation of x^T K x for each column from the rounding of the entries of K: an
/// eigenvalue below a few times that cannot be told from 0. With independent errors of the pairs of
/// entries it is entry_error sqrt(2 sum K_ij^2 x_i^2 x_j^2). Collective.
Vector rounding_of_quotients(const EigenProblem &problem, const Block &x);
/// An eigenvalue below so many standard deviations is that of a rigid motion.
inline constexpr double rounding_deviations = 10;

/// max |X^T M X - I|
double orthogonality_residual(const EigenProblem &problem, const Block &x);

} // namespace vibroimpact::modes
