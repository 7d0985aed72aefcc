// Whether a body under axial forces stands before it moves.
#pragma once

#include "modes/rayleigh_ritz.h"
#include "structure/assembly.h"

namespace vibroimpact::reduction {

/// Collective. Throws DefinitionError when axial forces exceed a buckling load, or a given
/// stiffness is not positive semidefinite: the stiffness then has negative eigenvalues, whose
/// number the signs of a factorisation give (Sylvester's law of inertia). The factorisation is that
/// of the problem, which has use for it.
void check_stability(const structure::AssembledBody &body, const modes::EigenProblem &problem);

} // namespace vibroimpact::reduction
