// The static displacement of a body under given loads.
#pragma once

#include "modes/rayleigh_ritz.h"

namespace vibroimpact::modes {

/// u with K u = load for each column, rows as in the matrices, the same on every rank. The direct
/// solution is improved with residuals from the accurate stiffness until the error in the energy
/// norm is below 1e-11, or round-off keeps it below 1e-8. The body must be held against every rigid
/// motion. Collective. Throws NumericalError when the improvement does not converge.
Matrix static_solution(const EigenProblem &problem, const Matrix &loads);

} // namespace vibroimpact::modes
