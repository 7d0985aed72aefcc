// SLEPc's part: all eigenvectors of K phi = lambda M phi in an interval.
#pragma once

#include "modes/vector_block.h"

namespace vibroimpact::modes {

/// Vectors of all eigenvalues in the interval by spectrum slicing: the inertia of factorisations
/// proves that none is missing. Collective. Throws NumericalError.
Block eigenvectors_between(Mat stiffness, Mat mass, double lower, double upper);

} // namespace vibroimpact::modes
