// From a body's definition to its reduced body: the Galerkin reduction to the lowest normal modes.
#pragma once

#include "reduction/body_definition.h"
#include "reduction/reduced_body.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// Collective; every rank gets the same bytes. Throws structure::DefinitionError when the
/// definition cannot be built, NumericalError when the eigen-solution fails.
ReducedBody reduce(const BodyDefinition &definition, MPI_Comm communicator);

} // namespace vibroimpact::reduction
