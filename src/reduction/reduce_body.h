// The entry point of the folder: a `subsection Body NAME` in, a reduced body out.
#pragma once

#include "parameters/values.h"
#include "reduction/reduced_body.h"

#include <mpi.h>

namespace vibroimpact::reduction {

/// A folder that keeps reduced bodies, each in a file named after a hash of what it was made from:
/// the section of the body, its mesh file, the program and the number of ranks (on which the last
/// digits of an eigen-solution depend). Entries that are damaged or do not fit are made anew.
struct BodyCache {
  std::string folder{};  ///< empty: none
  std::string program{}; ///< version of the program
};

/// Collective; every rank gets the same bytes. `body` is the subsection, `folder` that of the
/// parameter file. With the key Store the body is loaded when the file fits the definition, and
/// saved otherwise; without it the cache is looked into, and filled. Throws InputError that names
/// the key at fault, or NumericalError.
ReducedBody reduce_body(const parameters::Values &body, const std::string &name,
                        const std::string &folder, MPI_Comm communicator,
                        const BodyCache &cache = {});

} // namespace vibroimpact::reduction
