// What a result file says about how it was made.
#pragma once

#include "output/hdf5_results.h"

#include <mpi.h>
#include <string>
#include <vector>

namespace vibroimpact {

/// Version, libraries, ranks and processor of this run.
output::RunInformation run_information(const parameters::ParameterSet &parameters,
                                       const std::string &command_line, MPI_Comm communicator);

/// Version and commit.
std::string program_version();

/// The libraries that the program was built with, each with its version.
std::vector<std::string> libraries();

} // namespace vibroimpact
