// The matrices of a body out of given ones: without the rows that are held, and with springs and
// lumped masses.
#pragma once

#include "structure/assembly.h"

namespace vibroimpact::structure {

/// Everything but the load of a body whose model has given matrices. Collective. Throws
/// DefinitionError.
void assemble_given(AssembledBody &body, MPI_Comm communicator);

} // namespace vibroimpact::structure
