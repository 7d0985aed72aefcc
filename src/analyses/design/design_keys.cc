#include "analyses/design/design_keys.h"

#include "analyses/analysis.h"
#include "analyses/run/grid.h"
#include "common/error.h"
#include "common/scalar.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace vibroimpact::analyses {

using parameters::Values;

namespace {

double read_bound(const Values &section, const char *key, double otherwise) {
  return section.has(key) ? read_number_for(section, "Path", key).value : otherwise;
}

double read_start(const Values &section, const DesignKey &key) {
  if (section.has("Start"))
    return read_number_for(section, "Path", "Start").value;
  return key.logarithmic ? std::sqrt(key.lower * key.upper) : 0.5 * (key.lower + key.upper);
}

void check_order(const Values &section, const DesignKey &key) {
  if (!(key.lower < key.upper))
    section.reject("Upper", "must be greater than Lower");
  if (key.start < key.lower || key.start > key.upper)
    section.reject("Start", "must be from Lower to Upper");
  if (key.logarithmic && !(key.lower > 0 || (key.lower == -infinity && key.start > 0)))
    section.reject(section.has("Lower") ? "Lower" : "Start",
                   "must be greater than 0 when Scale = logarithmic");
}

double read_length(const Values &section, const DesignKey &key, double step) {
  if (key.bounded())
    return key.logarithmic ? std::log(key.upper / key.lower) : key.upper - key.lower;
  if (key.logarithmic)
    return 1;
  const double length = step > 0 ? 10 * step : std::abs(key.start);
  if (!(length > 0))
    section.reject("Start", "must not be 0 when Step is not set and Lower or Upper is not set");
  return length;
}

DesignKey read_key(const Values &section, const std::string &name) {
  if (!section.has("Lower") || !section.has("Upper"))
    section.require("Start");
  const char *example = section.has("Start") ? "Start" : "Lower";
  const parameters::SiNumber number = read_number_for(section, "Path", example);
  DesignKey key{.name = name,
                .parameter = {.path = section.text("Path"),
                              .unit = number.unit,
                              .values = {},
                              .origin = section.place("Path") + ":"}};
  key.logarithmic = section.choice("Scale") == "logarithmic";
  key.lower = read_bound(section, "Lower", -infinity);
  key.upper = read_bound(section, "Upper", infinity);
  key.start = read_start(section, key);
  check_order(section, key);
  if (key.logarithmic && section.has("Step"))
    section.reject("Step", "must not be set when Scale = logarithmic");
  const double step = read_bound(section, "Step", 0);
  if (section.has("Step") && !(step > 0 && step < key.upper - key.lower))
    section.reject("Step", "must be greater than 0 and less than Upper - Lower");
  key.length = read_length(section, key, step);
  if (step > 0)
    key.step = step / key.length;
  return key;
}

} // namespace

bool DesignKey::bounded() const { return std::isfinite(lower) && std::isfinite(upper); }

double DesignKey::coordinate(double value) const {
  const double from = bounded() ? lower : start;
  return (logarithmic ? std::log(value / from) : value - from) / length;
}

double DesignKey::value(double coordinate) const {
  if (bounded() && !(coordinate > 0))
    return lower;
  if (bounded() && coordinate >= 1)
    return upper;
  const double from = bounded() ? lower : start;
  const double free =
      logarithmic ? from * std::exp(coordinate * length) : from + coordinate * length;
  return std::min(std::max(free, lower), upper);
}

void declare_design_keys(parameters::Section &section) {
  section.named_subsection("Key", "A key that is changed.")
      .text("Path", "", "The key, as for --set: Contact/heads/Clearance, or Variables/lambda.")
      .required()
      .text("Lower", "", "Least value, with its unit.")
      .required("the analysis is a pareto front or a sensitivity")
      .text("Upper", "", "Largest value, with its unit.")
      .required("the analysis is a pareto front or a sensitivity")
      .text("Start", "",
            "Value of the first start, with its unit; empty means the middle between the bounds.")
      .required("Lower or Upper is not given")
      .text("Step", "",
            "First step of the search, with its unit; empty means a tenth of the way between the "
            "bounds or, where one is missing, of Start.")
      .choice("Scale", "linear", {"linear", "logarithmic"},
              "Do equal steps add equal amounts, or multiply by equal factors?");
}

std::vector<DesignKey> read_design_keys(const Values &section, const std::string &repeated,
                                        std::vector<std::string> &taken) {
  std::vector<DesignKey> keys;
  for (const std::string &name : section.instances("Key")) {
    const Values key = section.instance("Key", name);
    key.require("Path");
    check_changed_key(key, key.key_path("Path"), repeated, "analysis", taken);
    keys.push_back(read_key(key, name));
  }
  if (keys.empty())
    section.reject_section("at least one subsection Key NAME must be given");
  return keys;
}

std::vector<double> values_at(const std::vector<DesignKey> &keys, const Vector &coordinates) {
  std::vector<double> values;
  for (std::size_t k = 0; k < keys.size(); ++k)
    values.push_back(keys[k].value(coordinates[static_cast<Index>(k)]));
  return values;
}

std::vector<parameters::Override> overrides_at(const std::vector<DesignKey> &keys,
                                               const Vector &coordinates) {
  const std::vector<double> values = values_at(keys, coordinates);
  std::vector<parameters::Override> overrides;
  for (std::size_t k = 0; k < keys.size(); ++k)
    overrides.push_back(keys[k].parameter.at(values[k]));
  return overrides;
}

Vector start_of_search(const std::vector<DesignKey> &keys, long seed, std::size_t number) {
  Vector start(static_cast<Index>(keys.size()));
  for (std::size_t k = 0; k < keys.size(); ++k)
    start[static_cast<Index>(k)] = keys[k].coordinate(keys[k].start);
  if (number == 0)
    return start;
  std::seed_seq seeds{static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(number)};
  std::mt19937_64 generator(seeds);
  for (double &coordinate : start) // the 53 bits of a double, the same with every library
    coordinate = static_cast<double>(generator() >> 11) * 0x1p-53;
  return start;
}

bool all_bounded(const std::vector<DesignKey> &keys) {
  return std::all_of(keys.begin(), keys.end(), [](const DesignKey &key) { return key.bounded(); });
}

void require_bounds(const Values &section, const std::vector<DesignKey> &keys) {
  for (const DesignKey &key : keys) {
    const Values of_key = section.instance("Key", key.name);
    of_key.require("Lower");
    of_key.require("Upper");
  }
}

std::vector<std::string> paths_of(const std::vector<DesignKey> &keys,
                                  const std::vector<std::string> &more) {
  std::vector<std::string> paths;
  for (const DesignKey &key : keys)
    paths.push_back(key.parameter.path);
  paths.insert(paths.end(), more.begin(), more.end());
  return paths;
}

void check_at_bounds(const std::vector<DesignKey> &keys, const std::string &evaluated,
                     const std::function<void(const std::vector<parameters::Override> &)> &check) {
  const Vector start = start_of_search(keys, 0, 0);
  const auto check_at = [&](const Vector &coordinates) {
    const auto overrides = overrides_at(keys, coordinates);
    try {
      check(overrides);
    } catch (const InputError &error) {
      std::vector<std::string> values;
      for (const parameters::Override &change : overrides)
        values.push_back(change.path + " = " + change.value);
      throw InputError(std::string(error.what()) + "\n  This is the case " +
                       parameters::join(values, ", ") + " of the analysis " + evaluated +
                       ", which a search evaluates.");
    }
  };
  check_at(start);
  for (std::size_t k = 0; k < keys.size(); ++k)
    for (const double bound : {keys[k].lower, keys[k].upper})
      if (std::isfinite(bound)) {
        Vector at_bound = start;
        at_bound[static_cast<Index>(k)] = keys[k].coordinate(bound);
        check_at(at_bound);
      }
}

void refuse_selections(const Values &analysis, const std::string &evaluated) {
  for (const char *key :
       {"Excitations", "Active contacts", "Observed contacts", "Initial conditions"})
    if (analysis.given(key))
      analysis.reject(key, "must not be set here, but in the analysis " + evaluated);
}

std::string read_evaluated(const Values &section) {
  section.require("Repeat");
  return evaluated_analysis(section);
}

std::string evaluated_analysis(const Values &section) {
  const Values root = section.parameters().root();
  const std::string name = section.text("Repeat");
  section.require_known("Repeat", name, root.instances("Analysis"));
  if (evaluates_another(root.instance("Analysis", name)))
    section.reject("Repeat", "must be an analysis that does not evaluate another one itself");
  return name;
}

} // namespace vibroimpact::analyses
