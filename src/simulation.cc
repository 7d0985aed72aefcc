#include "simulation.h"

#include "analyses/design/measured_data.h"
#include "analyses/run/case_table.h"
#include "analyses/run/constants.h"
#include "common/error.h"
#include "common/log.h"
#include "common/petsc_stage.h"
#include "common/signals.h"
#include "contact/attachment_damping.h"
#include "contact/connection_laws.h"
#include "contact/contact_set.h"
#include "contact/laws.h"
#include "contact/unknown_flexibility.h"
#include "model/bearing.h"
#include "model/connection.h"
#include "model/excitation.h"
#include "model/initial_condition.h"
#include "model/system_damping.h"
#include "motion/settings.h"
#include "output/figure_sections.h"
#include "output/mode_tables.h"
#include "output/result_files.h"
#include "output/vtu_writer.h"
#include "parameters/text.h"
#include "reduction/beam_outlines.h"
#include "reduction/body_file.h"
#include "reduction/body_parameters.h"
#include "reduction/modal_parameters.h"
#include "reduction/reduce_body.h"
#include "run_information.h"

#include <algorithm>
#include <set>

namespace vibroimpact {

using analyses::RunSummary;
using contact::ContactFigures;
using parameters::Override;
using parameters::ParameterSet;
using parameters::Values;
using reduction::ReducedBody;

std::shared_ptr<const parameters::Section> declare_parameters() {
  auto root = std::make_shared<parameters::Section>("", "");
  root->text("Title", "", "What the file is about; shown in the results.")
      .names("Bodies", "", "Bodies of the model; empty means all that have a section.")
      .names("Contacts", "", "Contacts of the model; empty means all that have a section.")
      .names("Analyses", "",
             "What is computed, in this order; empty means all that have a section.")
      .text("File folder", "",
            "Folder that file names in this file refer to; empty means the folder "
            "of the parameter file.");
  reduction::declare_body(*root);
  model::declare_connections(*root);
  model::declare_bearings(*root);
  contact::declare_connection_laws(*root);
  model::declare_system_damping(*root);
  model::declare_spins(*root);
  contact::declare_contacts(*root);
  model::declare_excitations(*root);
  model::declare_initial_conditions(*root);
  motion::declare_integration(*root);
  analyses::declare_analyses(*root);
  derived::declare_derived(*root);
  output::declare_figures(*root);
  return root;
}

namespace {

std::filesystem::path body_file_name(const std::string &fingerprint) {
  return std::filesystem::path("bodies") / (reduction::content_hash(fingerprint) + ".body");
}

// Can a key at this path change a body?
bool reaches_bodies(const std::string &path) {
  return path.starts_with("Body") || path.starts_with("Variables");
}

// Has the grid point the same bodies as one before it? Of the keys that change none, only the first
// values bring new ones.
bool repeats_bodies(const std::vector<analyses::GridKey> &keys, std::size_t point) {
  const std::vector<std::size_t> index = analyses::grid_index(keys, point);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::vector<std::string> paths = analyses::grid_paths({keys[k]});
    if (index[k] > 0 && std::none_of(paths.begin(), paths.end(), reaches_bodies))
      return true;
  }
  return false;
}

} // namespace

Simulation::Simulation(std::shared_ptr<const ParameterSet> parameters, MPI_Comm communicator,
                       const std::string &body_cache)
    : parameters_(std::move(parameters)),
      communicator_(communicator), body_cache_{.folder = body_cache, .program = program_version()} {
  // The echo in the result folder must still find the files this one refers to.
  if (!parameters_->root().has("File folder"))
    parameters_ = parameters_->with({{.path = "File folder",
                                      .value = parameters_->folder(),
                                      .origin = "folder of the parameter file"}});
  read_tables();
  note_records();
}

// Behind the first reading the parameters hold the tables themselves.
void Simulation::read_tables() {
  const auto tables = analyses::tables_from_files(parameters_->root(), file_folder());
  if (!tables.empty())
    parameters_ = parameters_->with(tables);
}

// A run that is resumed, or repeated from its stored parameters, must find the records it had.
void Simulation::note_records() {
  if (parameters_->root().has("File checksums"))
    return;
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  std::set<std::string> noted;
  if (rank == 0)
    for (const auto &list : {model::record_checksums(parameters_->root(), file_folder()),
                             analyses::data_checksums(parameters_->root(), file_folder())})
      noted.insert(list.begin(), list.end());
  const Values root = parameters_->root();
  for (const std::string &name : root.instances("Body"))
    if (const std::string checksum =
            reduction::modal_file_checksum(root.instance("Body", name), file_folder());
        rank == 0 && !checksum.empty())
      noted.insert(checksum);
  std::string checksums = parameters::join({noted.begin(), noted.end()}, ", ");
  checksums = reduction::broadcast(std::move(checksums), communicator_);
  if (!checksums.empty())
    parameters_ = parameters_->with(
        {{.path = "File checksums", .value = checksums, .origin = "content of the records"}});
}

std::string Simulation::file_folder() const { return parameters_->root().text("File folder"); }

Simulation::Job Simulation::read_job(const std::string &name) const {
  const Values root = parameters_->root();
  const Values analysis = root.instance("Analysis", name);
  if (analysis.choice("Type") != analyses::grid_type)
    return {.name = name,
            .repeated = name,
            .keys = {},
            .parameters = analyses::with_constants(parameters_, {name})};
  const std::string repeated = analyses::repeated_analysis(analysis, root.instances("Analysis"));
  if (root.instance("Analysis", repeated).choice("Type") == analyses::grid_type)
    analysis.subsection("Parameter grid")
        .reject("Repeat",
                "must be an analysis that is no parameter grid; one grid takes any number of keys");
  std::vector<std::string> constant;
  for (const std::string &with : {name, repeated})
    for (const Override &change : analyses::read_constants(root.instance("Analysis", with)))
      constant.push_back(change.path);
  return {.name = name,
          .repeated = repeated,
          .keys = analyses::read_grid(analysis, repeated, constant),
          .parameters = analyses::with_constants(parameters_, {repeated, name})};
}

std::vector<Simulation::Job> Simulation::jobs() const {
  const Values root = parameters_->root();
  std::vector<Job> jobs;
  for (const std::string &name : analyses::listed_instances(root, "Analyses", "Analysis")) {
    Job job = read_job(name);
    refuse_file_names(job);
    jobs.push_back(std::move(job));
  }
  if (jobs.empty())
    root.reject_section("at least one subsection Analysis NAME must be given");
  return jobs;
}

void Simulation::reduce_bodies(const Values &root) {
  const std::vector<std::string> names = analyses::listed_instances(root, "Bodies", "Body");
  if (names.empty())
    root.reject_section("at least one subsection Body NAME must be given");
  for (const std::string &name : names) {
    const Values body = root.instance("Body", name);
    reduction::check_modal_file(body, file_folder(), root.names("File checksums"));
    const std::string fingerprint = body.fingerprint();
    if (reduced_.find(fingerprint) != reduced_.end())
      continue;
    std::optional<ReducedBody> kept = kept_body(fingerprint);
    reduced_.emplace(fingerprint, kept ? std::move(*kept)
                                       : reduction::reduce_body(body, name, file_folder(),
                                                                communicator_, body_cache_));
  }
}

// An eigen-solution on other ranks differs in its last digits; a resumed run therefore goes on with
// the very bodies it began with.
std::optional<ReducedBody> Simulation::kept_body(const std::string &fingerprint) const {
  if (resumed_folder_.empty())
    return std::nullopt;
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  const std::filesystem::path file = resumed_folder_ / body_file_name(fingerprint);
  const std::string bytes = reduction::broadcast(
      rank == 0 ? reduction::read_file(file.string()).value_or("") : std::string(), communicator_);
  std::string reason;
  return reduction::from_bytes(bytes, fingerprint, reason);
}

void Simulation::keep_bodies(output::RunFolder &folder) const {
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  for (const auto &[fingerprint, body] : reduced_)
    if (rank == 0)
      reduction::save_body(folder.claim(body_file_name(fingerprint)).string(), body, fingerprint);
}

// Every distinct body of the run that is known beforehand, those of grid points and of swept keys
// included, is reduced by all ranks together before the work is distributed.
void Simulation::reduce_all(const std::vector<Job> &jobs) {
  reduce_bodies(parameters_->root());
  for (const Job &job : jobs) {
    reduce_bodies(job.parameters->root());
    const std::vector<std::string> paths = analyses::grid_paths(job.keys);
    const bool grid_reaches = std::any_of(paths.begin(), paths.end(), reaches_bodies);
    const Values analysis = job.parameters->with(analyses::grid_overrides(job.keys, 0))->root();
    const auto variants =
        analyses::create_analysis(analysis.instance("Analysis", job.repeated))->variants();
    const bool sweep_reaches = !variants.empty() && reaches_bodies(variants.front().front().path);
    for (std::size_t point = 0;
         (grid_reaches || sweep_reaches) && point < analyses::grid_size(job.keys); ++point)
      if (!repeats_bodies(job.keys, point))
        reduce_point(job, point, sweep_reaches);
  }
}

void Simulation::reduce_point(const Job &job, std::size_t point, bool with_variants) {
  const auto set = job.parameters->with(analyses::grid_overrides(job.keys, point));
  const Values root = set->root();
  reduce_bodies(root);
  if (with_variants)
    for (const auto &variant :
         analyses::create_analysis(root.instance("Analysis", job.repeated))->variants())
      reduce_bodies(set->with(variant)->root());
}

// A body that was not known beforehand, because a jump is bracketed at values in between, is
// reduced by this rank alone.
const ReducedBody &Simulation::body(const Values &section, const std::string &name,
                                    std::optional<ReducedBody> &own) const {
  const auto known = reduced_.find(section.fingerprint());
  if (known != reduced_.end())
    return known->second;
  return own.emplace(
      reduction::reduce_body(section, name, file_folder(), MPI_COMM_SELF, body_cache_));
}

std::vector<std::shared_ptr<const ReducedBody>> Simulation::bodies(const Values &root) const {
  std::vector<std::shared_ptr<const ReducedBody>> list;
  for (const std::string &name : analyses::listed_instances(root, "Bodies", "Body")) {
    std::optional<ReducedBody> own;
    auto copy = std::make_shared<ReducedBody>(body(root.instance("Body", name), name, own));
    copy->name = name;
    list.push_back(std::move(copy));
  }
  return list;
}

derived::DerivedQuantities Simulation::derived_quantities(const std::vector<Job> &jobs) const {
  derived::check_analyses(parameters_->root());
  output::check_figures(parameters_->root());
  derived::DerivedQuantities quantities;
  for (const Job &job : jobs) {
    std::vector<Axis> axes = analyses::grid_axes(job.keys, *job.parameters);
    const Values first = job.parameters->with(analyses::grid_overrides(job.keys, 0))->root();
    const auto analysis = analyses::create_analysis(first.instance("Analysis", job.repeated));
    for (const Axis &axis : analysis->axes())
      axes.push_back(axis);
    quantities.add(job.parameters->root(), job.name, axes, job.keys);
  }
  return quantities;
}

namespace {

void log_groups(const contact::ContactSet &contacts, std::set<std::string> &reported) {
  for (const contact::ContactGroup &group : contacts.groups())
    if (reported.insert(group.name).second)
      log::info("contact " + group.name + ": " + std::to_string(group.count) + " contacts" +
                (group.unpaired > 0 ? "; nodes without a partner: " + std::to_string(group.unpaired)
                                    : "") +
                (group.held > 0
                     ? "; pairs left out as they cannot move: " + std::to_string(group.held)
                     : ""));
}

} // namespace

// A grid may change the law of a contact.
void Simulation::warn_of_unused_laws(const std::vector<Job> &jobs) const {
  std::vector<std::string> swept;
  for (const Job &job : jobs)
    for (const std::string &path : analyses::grid_paths(job.keys))
      swept.push_back(path);
  const Values root = parameters_->root();
  for (const std::string &name : analyses::listed_instances(root, "Contacts", "Contact"))
    if (std::find(swept.begin(), swept.end(), "Contact/" + name + "/Law") == swept.end())
      for (const std::string &warning :
           contact::unused_law_sections(root.instance("Contact", name)))
        log::warning(warning);
}

// Of the contacts of all analyses, as the first point of each has them. Tells of their pairings,
// and where the bodies keep too few modes for them.
std::vector<ContactFigures> Simulation::contacts_of(const std::vector<Job> &jobs) const {
  std::vector<ContactFigures> figures;
  std::set<std::string> groups;
  std::set<std::string> known;
  std::set<std::string> unknown, ringing;
  for (const Job &job : jobs) {
    const analyses::System system = build_case(job, analyses::grid_overrides(job.keys, 0)).system;
    log_groups(system.contacts, groups);
    for (const std::string &warning :
         {contact::unknown_flexibility_warning(system.contacts, system.model, unknown),
          contact::attachment_damping_warning(system.contacts, system.model, ringing)})
      if (!warning.empty())
        log::warning(warning);
    for (const ContactFigures &contact : contact::contact_figures(system.contacts, system.model))
      if (known.insert(contact.name).second)
        figures.push_back(contact);
  }
  for (const std::string &warning :
       {contact::flexibility_warning(figures), contact::impact_warning(figures)})
    if (!warning.empty())
      log::warning(warning);
  return figures;
}

RunSummary Simulation::run(const RunOptions &options) {
  if (options.existing == output::ExistingFolder::resume)
    resumed_folder_ = options.folder;
  const std::vector<Job> all = jobs();
  derived::DerivedQuantities derived = derived_quantities(all);
  {
    const PetscStage bodies("Bodies");
    reduce_all(all);
  }
  for (const Job &job : all)
    check_cases(job);
  try_evaluated(all);
  const DeferSignals results_at_stake;
  output::RunFolder folder(communicator_, options.folder, options.existing, parameters_->echo());
  log::open_file(folder.log_file().string());
  keep_bodies(folder);
  const std::vector<ContactFigures> contacts = contacts_of(all);
  std::vector<ReducedBody> reduced;
  output::Outlines outlines;
  for (const auto &body : bodies(parameters_->root())) {
    reduced.push_back(*body);
    outlines.push_back(reduction::beam_outlines(parameters_->root().instance("Body", body->name),
                                                body->name, file_folder(), communicator_));
  }
  output::FileSink sink(communicator_, folder,
                        run_information(*parameters_, options.command_line, communicator_), reduced,
                        std::chrono::seconds(60), std::move(derived), contacts, std::move(outlines),
                        output::read_yield_stresses(parameters_->root(), reduced));
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  if (rank == 0) {
    output::write_mode_files(folder, reduced);
    output::write_mode_tables(folder, reduced, parameters_->dimensionless());
  }
  warn_of_unused_laws(all);
  try {
    const PetscStage motions("Analyses");
    const RunSummary total = run_jobs(all, sink);
    sink.check_written();
    return total;
  } catch (const InputError &) {
    throw;
  } catch (const std::exception &error) {
    throw std::runtime_error(std::string(error.what()) +
                             "\n  Every point finished so far is kept; go on with --resume " +
                             options.folder.string());
  }
}

RunSummary Simulation::run_jobs(const std::vector<Job> &jobs, output::FileSink &sink) {
  RunSummary total;
  for (const Job &job : jobs) {
    const RunSummary summary = analyses::run_analysis(
        job.name, job.keys, analyses::grid_axes(job.keys, *job.parameters),
        [&](const std::vector<Override> &overrides) { return build_case(job, overrides); }, sink,
        communicator_);
    total.finished += summary.finished;
    total.failed += summary.failed;
    total.unbalanced += summary.unbalanced;
    total.interrupted = summary.interrupted;
    if (total.interrupted)
      break;
  }
  if (!total.interrupted)
    total.left_out = sink.missing_derived();
  return total;
}

} // namespace vibroimpact
