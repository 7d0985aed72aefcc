// What a file asks for that no run could do, or that would end in years: refused before anything
// runs.
#include "analyses/run/constants.h"
#include "common/error.h"
#include "reduction/body_file.h"
#include "simulation.h"

#include <algorithm>

namespace vibroimpact {

using analyses::GridKey;
using parameters::Values;

// Pictures of a motion would take the place of the mode shapes, or lie among the journals.
void Simulation::refuse_file_names(const Job &job) const {
  const Values transient =
      job.parameters->root().instance("Analysis", job.repeated).subsection("Transient");
  if ((job.name == "modes" || job.name == "journal" || job.name == "bodies") &&
      transient.given("Frames"))
    transient.reject("Frames", "Frames must not be set in an analysis with the name " + job.name +
                                   ", which the run uses for other files.");
}

// What a grid's values do to the file, the model and the analysis is known before anything runs;
// which combinations of them cannot be used, only the points say.
void Simulation::check_cases(const Job &job) const {
  check_swept_key(job);
  std::vector<std::size_t> first_shape;
  for (const std::size_t point : analyses::grid_probes(job.keys)) {
    try {
      const analyses::Case work = build_case(job, analyses::grid_overrides(job.keys, point));
      analyses::check_case(work);
      std::vector<std::size_t> shape;
      for (const Axis &axis : work.analysis->axes())
        shape.push_back(axis.size());
      if (point == 0)
        first_shape = shape;
      if (shape != first_shape)
        throw InputError("The grid must not change the number of points of the analysis " +
                         job.repeated + ".");
    } catch (const InputError &error) {
      if (job.keys.empty())
        throw;
      throw InputError(std::string(error.what()) + "\n  This is the case " +
                       analyses::grid_case(job.keys, point) + " of the parameter grid " + job.name +
                       ".");
    }
  }
}

// One rank alone finds out how far it comes in a limited time.
void Simulation::try_evaluated(const std::vector<Job> &jobs) const {
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  std::string refused;
  for (const Job &job : jobs)
    try {
      if (rank > 0 || !refused.empty())
        break;
      const analyses::Case work = build_case(job, analyses::grid_overrides(job.keys, 0));
      if (work.outcomes)
        work.analysis->try_outcomes(*work.outcomes);
    } catch (const InputError &error) {
      refused = error.what();
    }
  refused = reduction::broadcast(std::move(refused), communicator_);
  if (!refused.empty())
    throw InputError(refused);
}

// A grid and the analysis that it repeats must not change the same key, nor what the key With of
// one that is evaluated keeps constant.
void Simulation::check_swept_key(const Job &job) const {
  const Values root = job.parameters->with(analyses::grid_overrides(job.keys, 0))->root();
  const auto analysis = analyses::create_analysis(root.instance("Analysis", job.repeated));
  std::vector<std::string> changed;
  for (const std::string &path : analysis->changed_keys())
    changed.push_back(parameters_->key_path(path));
  if (const std::string evaluated = analysis->evaluated(); !evaluated.empty())
    for (const auto &constant : analyses::read_constants(root.instance("Analysis", evaluated)))
      changed.push_back(constant.path);
  for (const std::string &target : changed)
    for (const GridKey &key : job.keys) {
      refuse_swept(job, key, target);
      for (const GridKey &follower : key.followers)
        refuse_swept(job, follower, target);
    }
}

void Simulation::refuse_swept(const Job &job, const GridKey &key, const std::string &swept) const {
  if (key.target != swept)
    return;
  const Values grid =
      parameters_->root().instance("Analysis", job.name).subsection("Parameter grid");
  const std::string problem =
      " must not name a key that the analysis '" + job.repeated + "' changes itself.";
  if (key.name.empty())
    grid.reject("Cases", "Cases" + problem);
  grid.instance("Key", key.name).reject("Path", "Path" + problem);
}

} // namespace vibroimpact
