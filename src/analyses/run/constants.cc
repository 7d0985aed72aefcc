#include "analyses/run/constants.h"

#include "parameters/text.h"

#include <algorithm>

namespace vibroimpact::analyses {

using parameters::Override;
using parameters::Values;

namespace {

constexpr const char *with_key = "With";

/// "PATH = VALUE" each; a part without '=' belongs to the list that the part before it begins.
std::vector<std::string> assignments(const Values &analysis) {
  std::vector<std::string> list;
  for (const std::string &part : parameters::split_list(analysis.text(with_key))) {
    if (part.find('=') != std::string::npos)
      list.push_back(part);
    else if (list.empty())
      analysis.reject(with_key, "With must be PATH = VALUE, separated by commas: Variables/gap = "
                                "0.7 mm, Integration/Relative tolerance = 1e-10.");
    else
      list.back() += ", " + part;
  }
  return list;
}

bool is_fixed(const std::string &target) {
  static const std::vector<std::string> fixed{"Title",       "Analyses",       "Units",
                                              "File folder", "File checksums", "Variables"};
  const auto is_key_of_analysis = [&](const char *key) {
    return target.starts_with("Analysis ") && target.ends_with(std::string("/") + key);
  };
  return target.starts_with("Derived ") || is_key_of_analysis("Type") ||
         is_key_of_analysis(with_key) || is_key_of_analysis("Repeat") ||
         std::find(fixed.begin(), fixed.end(), target) != fixed.end();
}

/// The path in its one spelling.
std::string target_of(const Values &analysis, const std::string &path) {
  try {
    return analysis.parameters().key_path(path);
  } catch (const InputError &error) {
    analysis.reject(with_key, error.what());
  }
}

} // namespace

void declare_constants(parameters::Section &analysis) {
  analysis.text(with_key, "",
                "Values of keys of the model or of an analysis that hold for this analysis alone: "
                "PATH = VALUE, separated by commas; paths as for --set.");
}

std::vector<Override> read_constants(const Values &analysis) {
  std::vector<Override> constants;
  std::vector<std::string> targets;
  for (const std::string &assignment : assignments(analysis)) {
    const std::size_t equals = assignment.find('=');
    const std::string path = parameters::normalised(assignment.substr(0, equals));
    const std::string target = target_of(analysis, path);
    if (is_fixed(target))
      analysis.reject(with_key, "With must not set " + target + ".");
    if (std::find(targets.begin(), targets.end(), target) != targets.end())
      analysis.reject(with_key, "With must not set " + target + " twice.");
    targets.push_back(target);
    constants.push_back({.path = target,
                         .value = parameters::normalised(assignment.substr(equals + 1)),
                         .origin = analysis.place(with_key) + ":"});
  }
  return constants;
}

std::shared_ptr<const parameters::ParameterSet>
with_constants(const std::shared_ptr<const parameters::ParameterSet> &parameters,
               const std::vector<std::string> &names) {
  std::vector<Override> constants;
  for (const std::string &name : names)
    for (Override &constant : read_constants(parameters->root().instance("Analysis", name)))
      constants.push_back(std::move(constant));
  return constants.empty() ? parameters : parameters->with(constants);
}

} // namespace vibroimpact::analyses
