// The entry point of the folder: a `subsection Body NAME` in, a reduced body out.
#pragma once

#include "parameters/values.h"
#include "reduction/reduced_body.h"

#include <mpi.h>

namespace vibroimpact {

/// Collective; every rank gets the same bytes. `body` is the subsection, `folder` that of the
/// parameter file. With the key Store the body is loaded when the file fits the definition, and
/// saved otherwise. Throws InputError that names the key at fault, or NumericalError.
ReducedBody reduce_body(const parameters::Values &body, const std::string &name,
                        const std::string &folder, MPI_Comm communicator);

} // namespace vibroimpact
