// The command line of the program.
#pragma once

#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact {

struct CommandLine {
  enum class Task { run, check, print_parameters, print_help, print_version };

  Task task = Task::run;
  std::string parameter_file{};                  ///< may be empty with resume_folder
  std::string resume_folder{};                   ///< --resume
  std::string output_folder{};                   ///< --output; empty: output/ and the file's name
  bool overwrite = false;                        ///< --overwrite
  std::string body_cache{};                      ///< --body-cache; empty: none
  std::string print_format{};                    ///< --print-parameters
  std::vector<parameters::Override> overrides{}; ///< --set
  std::string petsc_options{};                   ///< everything after --petsc
  std::string whole{};                           ///< as typed, for the results
};

/// Throws InputError.
CommandLine parse_command_line(int argc, char **argv);

/// Usage, for --help.
std::string usage();

} // namespace vibroimpact
