// A body out of given matrices, with its nodes, supports, points and loads.
#pragma once

#include "structure/body_model.h"
#include "structure/matrix_definition.h"

#include <mpi.h>

namespace vibroimpact::structure {

/// Nodes of the table that have coordinates, in it or in the input deck, are nodes of the mesh;
/// those of the deck that the table does not have stand still. All other rows (of nodes without
/// coordinates, and differences of rows of one node and component) belong to internal nodes behind
/// them, see Mesh::internal_nodes. Collective. Throws DefinitionError.
BodyModel build_matrix_body(const MatrixDefinition &definition, MPI_Comm communicator);

} // namespace vibroimpact::structure
