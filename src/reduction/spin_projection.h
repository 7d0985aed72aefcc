// What turning adds, in the coordinates of a reduced body.
#pragma once

#include "modes/rayleigh_ritz.h"
#include "reduction/basis.h"
#include "reduction/reduced_body.h"

namespace vibroimpact::reduction {

/// Projected on shapes of the body at rest. In the rotating frame the axial forces are those of the
/// static solution under centrifugal forces. Collective. Throws DefinitionError when such a body is
/// not held.
SpinMatrices spin_matrices(const structure::AssembledBody &body, const modes::EigenProblem &problem,
                           const Basis &basis, const structure::SpinAxis &axis);

/// Of the elements that turn, by their strain rates: n x n, symmetric.
Matrix internal_damping(const structure::AssembledBody &body, const Basis &basis,
                        const structure::SpinAxis &axis);

} // namespace vibroimpact::reduction
