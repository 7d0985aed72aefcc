#include "analyses/run/stored_state.h"

#include "common/hdf5_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vibroimpact::analyses {

namespace {

Hdf5File open_run(const parameters::Values &section) {
  const std::filesystem::path folder = section.parameters().root().text("File folder");
  std::filesystem::path file = folder / section.text("State run");
  if (std::filesystem::is_directory(file))
    file /= "results.h5";
  try {
    return Hdf5File::open(file);
  } catch (const std::runtime_error &error) {
    section.reject("State run",
                   "must be the result folder of an earlier run: " + std::string(error.what()));
  }
}

std::string dataset_of(const parameters::Values &section, const Hdf5File &file) {
  section.require("State analysis");
  const std::string path = "/analysis/" + section.text("State analysis") + "/state";
  if (!file.contains(path) || file.is_group(path))
    section.reject(
        "State analysis",
        "must be an analysis of that run whose points have a state: a stepped sweep, steady state, "
        "periodic orbit or branch, or the special points of one, as NAME/special.");
  return path;
}

// Position of the state's first entry, from numbers that count from 1 along the dimensions before
// it.
std::size_t offset_of(const parameters::Values &section, const Shape &shape) {
  const std::vector<double> numbers = section.quantities("State point");
  bool fits = numbers.size() + 1 == shape.size();
  std::size_t offset = 0;
  std::string lengths;
  for (std::size_t k = 0; k + 1 < shape.size(); ++k) {
    lengths += (k > 0 ? ", " : "") + std::to_string(shape[k]);
    fits =
        fits && numbers[k] <= static_cast<double>(shape[k]) && std::floor(numbers[k]) == numbers[k];
    offset = fits ? offset * shape[k] + static_cast<std::size_t>(numbers[k]) - 1 : 0;
  }
  if (!fits)
    section.reject(
        "State point",
        shape.size() > 1
            ? "must be the numbers of a point along the axes of that analysis, from 1 up to " +
                  lengths + "."
            : "must not be set when the analysis has a single point");
  return offset * shape.back();
}

} // namespace

void declare_stored_state(parameters::Section &section) {
  section
      .text("State run", "",
            "Result folder of an earlier run, or its results.h5, that holds the state from which "
            "Newton's method starts, instead of State.")
      .text("State analysis", "",
            "The analysis of that run; NAME/special for the special points of a branch.")
      .required("State run is given")
      .quantities(
          "State point", "", parameters::dimension::none,
          parameters::Range{.lower = 1, .upper = 1e9}, "",
          "Numbers of the point along the axes of that analysis, from 1, as in its summary; "
          "of a branch that of the point. Empty for an analysis without axes.",
          0, 20);
}

std::vector<double> read_stored_state(const parameters::Values &section) {
  if (!section.has("State run")) {
    for (const char *key : {"State analysis", "State point"})
      if (section.has(key))
        section.reject(key, "must not be set when State run is not set");
    return {};
  }
  const Hdf5File file = open_run(section);
  const std::string path = dataset_of(section, file);
  const Shape shape = file.shape(path);
  const std::size_t offset = offset_of(section, shape);
  const std::vector<double> all = file.read_numbers(path);
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(offset);
  std::vector<double> state(first, first + static_cast<std::ptrdiff_t>(shape.back()));
  if (std::any_of(state.begin(), state.end(), [](double entry) { return std::isnan(entry); }))
    section.reject(shape.size() > 1 ? "State point" : "State analysis",
                   "must be a point with a state; this one is missing or has failed");
  return state;
}

} // namespace vibroimpact::analyses
