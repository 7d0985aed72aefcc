// Whether a body under axial forces stands before it moves.
#pragma once

#include "structure/assembly.h"

namespace vibroimpact::reduction {

/// Collective. Throws DefinitionError when axial forces exceed a buckling load: the stiffness then
/// has negative eigenvalues, whose number the signs of a factorisation give (Sylvester's law of
/// inertia).
void check_stability(const structure::AssembledBody &body);

} // namespace vibroimpact::reduction
