// The static displacement of a body under given loads.
#pragma once

#include "modes/rayleigh_ritz.h"

namespace vibroimpact::modes {

/// u with K u = load, rows as in the matrices, the same on every rank. The direct solution is
/// improved with residuals from the accurate stiffness until the work of the residual is below
/// 1e-12 of that of the load, in the energy norm. The body must be held against every rigid motion.
/// Collective. Throws NumericalError when the improvement does not converge.
Vector static_solution(const EigenProblem &problem, const Vector &load);

} // namespace vibroimpact::modes
