// SLEPc's part: approximate eigenvectors of K phi = lambda M phi by Krylov-Schur with
// shift-and-invert.
#pragma once

#include "modes/factorisation.h"

namespace vibroimpact::modes {

struct FoundVectors {
  Block vectors;
  Factorisation shifted; ///< K - shift M, with which they were found
};

/// Vectors of at least `count` eigenvalues nearest to `shift` from above, which must lie below the
/// spectrum; fewer only when the mass matrix has a smaller rank. The start vector is fixed.
/// Throws NumericalError when the iteration does not converge.
FoundVectors lowest_eigenvectors(Mat stiffness, Mat mass, double shift, int count);

/// Vectors of all eigenvalues in the interval by spectrum slicing: the inertia of factorisations
/// proves that none is missing.
Block eigenvectors_between(Mat stiffness, Mat mass, double lower, double upper);

} // namespace vibroimpact::modes
