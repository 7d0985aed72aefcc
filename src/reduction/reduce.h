// From a body's definition to its reduced body: the Galerkin reduction to the lowest normal modes.
#pragma once

#include "reduction/body_definition.h"
#include "reduction/reduced_body.h"
#include "structure/body_model.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// Nodes and elements, or matrices, of a body with a mesh. Collective. Throws
/// structure::DefinitionError.
structure::BodyModel build_model(const BodyDefinition &definition, MPI_Comm communicator);

/// Collective; every rank gets the same bytes. Throws structure::DefinitionError when the
/// definition cannot be built, NumericalError when the eigen-solution fails.
ReducedBody reduce(const BodyDefinition &definition, MPI_Comm communicator);

} // namespace vibroimpact::reduction
