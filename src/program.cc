#include "program.h"

#include "command_line.h"
#include "common/error.h"
#include "common/log.h"
#include "common/petsc_error.h"
#include "common/petsc_stage.h"
#include "common/signals.h"
#include "launcher.h"
#include "run_information.h"
#include "simulation.h"

#include <deal.II/base/mpi.h>

#include <petscsys.h>

#include <dlfcn.h>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

namespace vibroimpact {

using output::ExistingFolder;

namespace {

enum ExitCode : int {
  all_done = 0,
  bad_input = 1,
  broke_off = 2,
  points_failed = 3,
  stopped = stopped_exit_code
};

// One BLAS thread for each rank: more would fight over the cores. The function exists only where
// the BLAS is OpenBLAS.
void use_one_blas_thread() {
  using SetThreads = void (*)(int);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what dlsym returns is a function
  if (auto set_threads =
          reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set_threads(1);
}

std::shared_ptr<const parameters::ParameterSet> read_parameters(const CommandLine &line) {
  const std::string file = line.parameter_file.empty()
                               ? output::RunFolder::parameters_file(line.resume_folder).string()
                               : line.parameter_file;
  return parameters::ParameterSet::read(declare_parameters(), file, line.overrides);
}

RunOptions run_options(const CommandLine &line) {
  if (!line.resume_folder.empty())
    return {.folder = line.resume_folder,
            .existing = ExistingFolder::resume,
            .command_line = line.whole};
  std::filesystem::path folder = line.output_folder;
  if (folder.empty())
    folder = std::filesystem::path("output") / std::filesystem::path(line.parameter_file).stem();
  return {.folder = folder,
          .existing = line.overwrite ? ExistingFolder::overwrite : ExistingFolder::refuse,
          .command_line = line.whole};
}

void print_version() {
  std::string text = "vibroimpact " + program_version();
  for (const std::string &library : libraries())
    text += "\n  " + library;
  log::info(text);
}

// Files for ParaView in the folder, a few of them.
std::string pictures(const std::filesystem::path &folder) {
  std::set<std::string> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".pvd")
      files.insert(entry.path().filename().string());
  constexpr std::size_t most = 4;
  std::string list;
  std::size_t listed = 0;
  for (const std::string &file : files)
    if (listed++ < most)
      list += (list.empty() ? "; for ParaView: " : ", ") + file;
  return files.size() > most ? list + ", ..." : list;
}

// Messages at the end of a run with exit code 3 or 0.
int tell_end(const analyses::RunSummary &summary, const std::string &folder) {
  if (summary.failed > 0)
    log::warning(std::to_string(summary.failed) +
                 " points failed; status and reason in results.h5 say which and why.");
  log::info("Results: " + folder + "/results.h5 and summary.txt" + pictures(folder) +
            "; figures: vibroimpact-plot " + folder);
  if (!summary.left_out.empty())
    throw InputError(summary.left_out);
  return summary.failed > 0 ? points_failed : all_done;
}

int run(const CommandLine &line) {
  Simulation simulation(read_parameters(line), MPI_COMM_WORLD, line.body_cache);
  if (line.task == CommandLine::Task::check) {
    simulation.check();
    log::info("The file can be run.");
    return all_done;
  }
  const RunOptions options = run_options(line);
  const analyses::RunSummary summary = simulation.run(options);
  const std::string folder = options.folder.string();
  if (summary.unbalanced > 0)
    log::warning("the energy balance is not closed at " + std::to_string(summary.unbalanced) +
                 (summary.unbalanced == 1 ? " point" : " points") +
                 "; energy_residual in results.h5 shows where and by how much. A smaller "
                 "Relative tolerance helps, with another Method than "
                 "exact also a smaller Absolute tolerance; where neither does, compare with "
                 "Method = rk.");
  if (summary.interrupted) {
    log::info("Stopped. Everything finished so far is in " + folder + "; go on with --resume " +
              folder);
    return stopped;
  }
  return tell_end(summary, folder);
}

// What needs neither MPI nor PETSc; nothing when the line asks for more than a text.
std::optional<int> print_only(const CommandLine &line) {
  switch (line.task) {
  case CommandLine::Task::print_help:
    log::info(usage());
    return all_done;
  case CommandLine::Task::print_version:
    print_version();
    return all_done;
  case CommandLine::Task::print_parameters:
    log::info(parameters::print_declarations(*declare_parameters(), line.print_format));
    return all_done;
  default:
    return std::nullopt;
  }
}

int perform(const CommandLine &line) {
  if (const std::optional<int> code = print_only(line))
    return *code;
  PetscOptionsInsertString(nullptr, line.petsc_options.c_str());
  begin_petsc_log();
  return run(line);
}

// The other ranks may be waiting for this one.
void end_other_ranks() {
  int started = 0;
  int ranks = 1;
  MPI_Initialized(&started);
  if (started != 0)
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (ranks > 1)
    MPI_Abort(MPI_COMM_WORLD, broke_off);
}

// The same InputError is found on every rank; rank 0 prints it.
template <typename Work> auto guarded(int rank, const Work &work) -> decltype(work()) {
  try {
    return work();
  } catch (const InputError &error) {
    if (rank == 0)
      std::cerr << error.what() << std::endl;
    return bad_input;
  } catch (const std::exception &error) {
    std::cerr << "vibroimpact: " << error.what() << std::endl;
    end_other_ranks();
    return broke_off;
  }
}

// Without a launcher there is one process, which can print texts and refuse arguments by itself.
std::optional<int> before_mpi(int argc, char **argv) {
  return guarded(0, [&] { return print_only(parse_command_line(argc, argv)); });
}

} // namespace

int run_program(int argc, char **argv) {
  const bool launched = started_by_launcher();
  // Under a launcher one of the processes speaks for all, once they know who they are.
  install_signal_handlers(!launched);
  if (!launched) {
    if (const std::optional<int> code = before_mpi(argc, argv))
      return *code;
    prepare_single_process();
  }
  use_one_blas_thread();
  // PETSc must see none of the program's own arguments, nor a .petscrc of the user.
  char skip[] = "-skip_petscrc";
  char *private_arguments[] = {argv[0], skip, nullptr};
  int count = 2;
  char **petsc_arguments = private_arguments;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(count, petsc_arguments, 1);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  log::set_rank(rank);
  keep_petsc_errors();
  install_signal_handlers(rank == 0); // again: the libraries set their own
  return guarded(rank, [&] { return perform(parse_command_line(argc, argv)); });
}

} // namespace vibroimpact
