// The sections of a parameter file that describe bodies.
#pragma once

#include "parameters/values.h"
#include "reduction/body_definition.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// Declares `subsection Body NAME`.
void declare_body(parameters::Section &root);

/// Collective: rank 0 reads the mesh file. `folder` is that of the parameter file. Throws
/// InputError for values that contradict each other.
BodyDefinition read_body(const parameters::Values &body, const std::string &name,
                         const std::string &folder, MPI_Comm communicator);

} // namespace vibroimpact::reduction
