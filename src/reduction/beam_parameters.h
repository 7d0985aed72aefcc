// The keys of a parameter file that only beams have.
#pragma once

#include "parameters/values.h"
#include "structure/beam_definition.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// `subsection Section`, `subsection Member NAME` and `subsection Hinge NAME` of a body.
void declare_beams(parameters::Section &body);

/// Collective: rank 0 reads the mesh file. Throws InputError.
structure::BeamDefinition read_beam_definition(const parameters::Values &body,
                                               const std::string &folder, MPI_Comm communicator);

} // namespace vibroimpact::reduction
