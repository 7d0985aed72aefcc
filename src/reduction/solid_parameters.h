// The keys of a parameter file that only solids have.
#pragma once

#include "parameters/values.h"
#include "structure/solid_definition.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// Block; its Divisions are declared with those of plates.
void declare_solid_geometry(parameters::Section &geometry);
/// `subsection Solid NAME` of a body.
void declare_solids(parameters::Section &body);

/// Collective: rank 0 reads the mesh file. Throws InputError.
structure::SolidDefinition read_solid_definition(const parameters::Values &body,
                                                 const std::string &folder, MPI_Comm communicator);

} // namespace vibroimpact::reduction
