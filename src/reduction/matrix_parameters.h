// The keys of a parameter file that only bodies from given matrices have.
#pragma once

#include "parameters/values.h"
#include "structure/matrix_definition.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// `subsection Matrices` of a body.
void declare_matrices(parameters::Section &body);

/// Collective: rank 0 reads the table and the input deck. Throws InputError.
structure::MatrixDefinition read_matrix_definition(const parameters::Values &body,
                                                   const std::string &folder,
                                                   MPI_Comm communicator);

} // namespace vibroimpact::reduction
