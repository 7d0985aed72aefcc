#include "command_line.h"

#include "common/error.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <sstream>

namespace vibroimpact {

namespace {

namespace options = boost::program_options;

options::options_description described_options() {
  options::options_description description("Options");
  description.add_options()                                                             //
      ("help", "show this text")                                                        //
      ("version", "show version and libraries")                                         //
      ("check", "read and check the file, estimate the cost, run nothing")              //
      ("set", options::value<std::vector<std::string>>()->value_name("PATH=VALUE"),     //
       "override a key, e.g. --set \"Contact/stop/Clearance=0.7 mm\"; may be repeated") //
      ("output", options::value<std::string>()->value_name("DIR"),                      //
       "folder of the results; default: output/ and the name of the file")              //
      ("overwrite", "replace the results an earlier run left in that folder")           //
      ("resume", options::value<std::string>()->value_name("DIR"),                      //
       "go on where a run in this folder stopped")                                      //
      ("body-cache", options::value<std::string>()->value_name("DIR"),                  //
       "folder that keeps reduced bodies for later runs; default: none is kept")        //
      ("print-parameters", options::value<std::string>()->value_name("FORMAT"),         //
       "print the reference of all keys: markdown, prm or json");
  return description;
}

options::variables_map parse(const std::vector<std::string> &arguments) {
  options::options_description all = described_options();
  all.add_options()("file", options::value<std::vector<std::string>>(), "");
  options::positional_options_description positional;
  positional.add("file", -1);
  options::variables_map map;
  try {
    const int style =
        options::command_line_style::unix_style & ~options::command_line_style::allow_guessing;
    options::store(options::command_line_parser(arguments)
                       .options(all)
                       .positional(positional)
                       .style(style)
                       .run(),
                   map);
    options::notify(map);
  } catch (const options::error &error) {
    throw InputError(std::string("command line: ") + error.what() + "\n  see vibroimpact --help.");
  }
  return map;
}

CommandLine::Task task_of(const options::variables_map &map) {
  if (map.count("help") > 0)
    return CommandLine::Task::print_help;
  if (map.count("version") > 0)
    return CommandLine::Task::print_version;
  if (map.count("print-parameters") > 0)
    return CommandLine::Task::print_parameters;
  return map.count("check") > 0 ? CommandLine::Task::check : CommandLine::Task::run;
}

std::string text(const options::variables_map &map, const std::string &name) {
  if (map.count(name) == 0)
    return "";
  const std::string value = map[name].as<std::string>();
  if (value.empty())
    throw InputError("command line: --" + name + " must not be empty.\n  see vibroimpact --help.");
  return value;
}

void check_combination(const CommandLine &line) {
  if (line.task == CommandLine::Task::print_parameters && line.print_format != "markdown" &&
      line.print_format != "prm" && line.print_format != "json")
    throw InputError("--print-parameters " + line.print_format +
                     "\n  the format is markdown, prm or json.");
  const bool needs_file =
      line.task == CommandLine::Task::run || line.task == CommandLine::Task::check;
  if (needs_file && line.parameter_file.empty() && line.resume_folder.empty())
    throw InputError("command line: a parameter file is needed, e.g. vibroimpact "
                     "params/impacting-beams.prm\n  see vibroimpact --help.");
  if (line.overwrite && !line.resume_folder.empty())
    throw InputError("command line: --overwrite and --resume exclude each other.");
  if (!line.output_folder.empty() && !line.resume_folder.empty())
    throw InputError("command line: --output and --resume exclude each other.");
}

} // namespace

CommandLine parse_command_line(int argc, char **argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  CommandLine line{.whole =
                       boost::algorithm::join(std::vector<std::string>(argv, argv + argc), " ")};
  const auto petsc = std::find(arguments.begin(), arguments.end(), "--petsc");
  if (petsc != arguments.end()) {
    line.petsc_options =
        boost::algorithm::join(std::vector<std::string>(petsc + 1, arguments.end()), " ");
    arguments.erase(petsc, arguments.end());
  }
  const options::variables_map map = parse(arguments);
  line.task = task_of(map);
  line.resume_folder = text(map, "resume");
  line.output_folder = text(map, "output");
  line.body_cache = text(map, "body-cache");
  line.print_format = text(map, "print-parameters");
  line.overwrite = map.count("overwrite") > 0;
  if (map.count("file") > 0) {
    const auto files = map["file"].as<std::vector<std::string>>();
    if (files.size() > 1)
      throw InputError("command line: one parameter file at a time; got " + files[0] + " and " +
                       files[1] + ".");
    line.parameter_file = files[0];
  }
  if (map.count("set") > 0)
    for (const std::string &assignment : map["set"].as<std::vector<std::string>>())
      line.overrides.push_back(parameters::split_override(assignment, "--set"));
  check_combination(line);
  return line;
}

std::string usage() {
  std::ostringstream text;
  text << "vibroimpact: vibro-impact dynamics of structures\n\n"
          "  vibroimpact FILE [options] [--petsc PETSC OPTIONS]\n"
          "  mpirun -np 2 vibroimpact FILE [options]\n"
          "  vibroimpact --resume DIR [FILE]\n\n"
       << described_options()
       << "\nExit code: 0 all done, 1 the input cannot be used, 2 the run broke off,\n"
          "3 some points failed (see status and reason in results.h5), 4 stopped by a signal.\n";
  return text.str();
}

} // namespace vibroimpact
