// Owns the stages of a run in the order data flows; alone sees every folder.
#pragma once

#include "analyses/run/cost.h"
#include "contact/truncation.h"
#include "derived/derived_quantities.h"
#include "derived/repeated_analysis.h"
#include "output/run_folder.h"
#include "parameters/values.h"
#include "reduction/reduce_body.h"

#include <filesystem>
#include <map>
#include <memory>
#include <mpi.h>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::output {
class FileSink;
}

namespace vibroimpact {

/// Every section a parameter file can hold.
std::shared_ptr<const parameters::Section> declare_parameters();

struct RunOptions {
  std::filesystem::path folder; ///< of the results
  output::ExistingFolder existing = output::ExistingFolder::refuse;
  std::string command_line;
};

class Simulation {
public:
  /// Collective. `parameters` is a complete, checked file, `body_cache` a folder or empty.
  Simulation(std::shared_ptr<const parameters::ParameterSet> parameters, MPI_Comm communicator,
             const std::string &body_cache = "");

  /// Collective. Reduces the bodies, builds every analysis without running it and logs what it
  /// would cost; warns of a run of more than an hour. Throws InputError.
  void check();

  /// Collective. Runs all analyses and writes the results. Throws InputError before anything runs,
  /// std::runtime_error when results cannot be written.
  analyses::RunSummary run(const RunOptions &options);

private:
  struct Job {
    std::string name;     ///< of the analysis section that is run
    std::string repeated; ///< section that says what is computed: `name`, or what a grid repeats
    std::vector<analyses::GridKey> keys;
    /// With what holds for this analysis alone.
    std::shared_ptr<const parameters::ParameterSet> parameters;
  };

  std::vector<Job> jobs() const;
  Job read_job(const std::string &name) const;
  void reduce_all(const std::vector<Job> &jobs);
  void note_records();
  void read_tables();
  void reduce_point(const Job &job, std::size_t point, bool with_variants);
  const reduction::ReducedBody &body(const parameters::Values &section, const std::string &name,
                                     std::optional<reduction::ReducedBody> &own) const;
  void reduce_bodies(const parameters::Values &root);
  std::vector<std::shared_ptr<const reduction::ReducedBody>>
  bodies(const parameters::Values &root) const;
  analyses::Case build_case(const Job &job,
                            const std::vector<parameters::Override> &overrides) const;
  analyses::Case build_case(const std::shared_ptr<const parameters::ParameterSet> &parameters,
                            const std::string &name) const;
  derived::Repetition repetition(const std::shared_ptr<const parameters::ParameterSet> &parameters,
                                 const std::string &name,
                                 const std::vector<parameters::Override> &more) const;
  std::optional<reduction::ReducedBody> kept_body(const std::string &fingerprint) const;
  void keep_bodies(output::RunFolder &folder) const;
  derived::DerivedQuantities derived_quantities(const std::vector<Job> &jobs) const;
  void refuse_file_names(const Job &job) const;
  void check_cases(const Job &job) const;
  void check_swept_key(const Job &job) const;
  void try_evaluated(const std::vector<Job> &jobs) const;
  void refuse_swept(const Job &job, const analyses::GridKey &key, const std::string &swept) const;
  void warn_of_unused_laws(const std::vector<Job> &jobs) const;
  analyses::Cost log_cost(const Job &job, double seconds) const;
  void log_costs(const std::vector<Job> &jobs) const;
  analyses::RunSummary run_jobs(const std::vector<Job> &jobs, output::FileSink &sink);
  std::vector<contact::ContactFigures> contacts_of(const std::vector<Job> &jobs) const;
  std::string file_folder() const;

  std::shared_ptr<const parameters::ParameterSet> parameters_;
  MPI_Comm communicator_;
  reduction::BodyCache body_cache_;
  std::filesystem::path resumed_folder_; ///< empty when nothing is resumed
  std::map<std::string, reduction::ReducedBody>
      reduced_; ///< by the fingerprint of the body's section
};

} // namespace vibroimpact
