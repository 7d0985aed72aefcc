#include "run_information.h"

#include "version.h"

#include <deal.II/base/config.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <petscversion.h>
#include <slepcversion.h>

#include <fstream>

namespace vibroimpact {

namespace {

std::string dotted(int major, int minor, int subminor) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(subminor);
}

std::string processor_name() {
  std::ifstream information("/proc/cpuinfo");
  std::string line;
  while (std::getline(information, line))
    if (line.starts_with("model name") && line.find(':') != std::string::npos)
      return line.substr(line.find(':') + 2);
  return "unknown";
}

} // namespace

std::vector<std::string> libraries() {
  return {
      "deal.II " + dotted(DEAL_II_VERSION_MAJOR, DEAL_II_VERSION_MINOR, DEAL_II_VERSION_SUBMINOR),
      "PETSc " + dotted(PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR),
      "SLEPc " + dotted(SLEPC_VERSION_MAJOR, SLEPC_VERSION_MINOR, SLEPC_VERSION_SUBMINOR),
      "Eigen " + dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
      "Boost " + dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)};
}

std::string program_version() { return std::string(version) + " (" + commit + ")"; }

output::RunInformation run_information(const parameters::ParameterSet &parameters,
                                       const std::string &command_line, MPI_Comm communicator) {
  int ranks = 1;
  MPI_Comm_size(communicator, &ranks);
  return {.version = version,
          .commit = commit,
          .parameters = parameters.echo(),
          .command_line = command_line,
          .libraries = libraries(),
          .ranks = ranks,
          .processor = processor_name(),
          .dimensionless = parameters.dimensionless()};
}

} // namespace vibroimpact
