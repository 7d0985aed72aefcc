#include "launcher.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace vibroimpact {

bool started_by_launcher() {
  // Set by mpirun of Open MPI, by launchers with PMIx, by those with PMI (MPICH, Intel) and by
  // srun. A batch script of Slurm that starts the program without srun has no step.
  constexpr std::array variables = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK",
                                    "SLURM_STEP_ID", "SLURM_STEPID"};
  return std::any_of(variables.begin(), variables.end(),
                     [](const char *variable) { return std::getenv(variable) != nullptr; });
}

void prepare_single_process() {
  constexpr std::array<std::pair<const char *, const char *>, 4> settings = {
      {{"OMPI_MCA_ess_singleton_isolated",
        "1"}, // no daemon
              // No folder, which programs that start and end at the same time take from each other.
       {"OMPI_MCA_orte_create_session_dirs", "0"},
       {"OMPI_MCA_pml", "ob1"},    // messages by the byte transfer layers below
       {"OMPI_MCA_btl", "self"}}}; // of which one process needs that to itself
  constexpr int overwrite = 0;
  for (const auto &[variable, value] : settings)
    setenv(variable, value, overwrite);
}

} // namespace vibroimpact
