#include "analyses/run/grid.h"

#include "analyses/run/case_table.h"
#include "parameters/text.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <charconv>
#include <optional>

namespace vibroimpact::analyses {

namespace {

constexpr const char *grid_section = "Parameter grid";

/// A text that is a whole number without a unit.
std::optional<long> whole_number(const std::string &text) {
  long number = 0;
  const char *const end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && behind == end ? std::optional(number) : std::nullopt;
}

// Number i of so many values from one whole number to another, where it is one too.
std::optional<long> whole_between(const std::string &first, const std::string &last, long points,
                                  long i) {
  const std::optional<long> low = whole_number(first), high = whole_number(last);
  if (!low || !high || (*high - *low) * i % (points - 1) != 0)
    return std::nullopt;
  return *low + (*high - *low) * i / (points - 1);
}

// Equally spaced values as expressions of the two ends, so that any unit will do; whole numbers as
// themselves, for keys that take no others.
std::vector<std::string> between(const std::string &first, const std::string &last, long points) {
  std::vector<std::string> values = {first};
  for (long i = 1; i + 1 < points; ++i)
    if (const std::optional<long> whole = whole_between(first, last, points, i))
      values.push_back(std::to_string(*whole));
    else
      values.push_back("(" + first + ") + " + std::to_string(i) + " / " +
                       std::to_string(points - 1) + " * ((" + last + ") - (" + first + "))");
  values.push_back(last);
  return values;
}

GridKey read_key(const parameters::Values &key) {
  key.require("Path");
  GridKey grid_key{.path = key.text("Path"),
                   .values = parameters::split_list(key.text("Values")),
                   .target = key.key_path("Path"),
                   .origin = key.place(key.has("Values") ? "Values" : "First") + ":"};
  if (std::find(grid_key.values.begin(), grid_key.values.end(), "") != grid_key.values.end())
    key.reject("Values", "must be values separated by commas, but one of them is empty");
  if (!grid_key.values.empty() && (key.has("First") || key.has("Last")))
    key.reject("Values", "must not be set when First or Last is set");
  if (grid_key.values.empty()) {
    key.require("First");
    key.require("Last");
    grid_key.values = between(key.text("First"), key.text("Last"), key.integer("Points"));
  }
  return grid_key;
}

void attach_follower(const parameters::Values &key, const std::string &name,
                     const std::vector<std::string> &leaders, std::vector<GridKey> &keys) {
  key.require_known("Tied to", key.text("Tied to"), leaders);
  const auto found = std::find(leaders.begin(), leaders.end(), key.text("Tied to"));
  GridKey &leader = keys[static_cast<std::size_t>(found - leaders.begin())];
  GridKey follower = read_key(key);
  follower.name = name;
  if (follower.values.size() != leader.values.size())
    key.reject(key.has("Values") ? "Values" : "Points",
               "must give " + std::to_string(leader.values.size()) +
                   " values, as many as the key that Tied to names");
  leader.followers.push_back(std::move(follower));
}

} // namespace

void check_changed_key(const parameters::Values &key, const std::string &target,
                       const std::string &repeated, const std::string &owner,
                       std::vector<std::string> &taken) {
  check_changed_key(key, "Path", target, repeated, owner, taken);
}

void check_changed_key(const parameters::Values &section, const std::string &name,
                       const std::string &target, const std::string &repeated,
                       const std::string &owner, std::vector<std::string> &taken) {
  const std::string own = "Analysis " + repeated + "/";
  const bool reaches = target.starts_with("Analysis ")
                           ? target.starts_with(own) && target != own + "Type"
                           : !target.starts_with("Derived ");
  static const std::vector<std::string> fixed{"Title", "Analyses", "File folder", "File checksums"};
  if (!reaches || std::find(fixed.begin(), fixed.end(), target) != fixed.end())
    section.reject(name, name + " must name a key that changes the model or the analysis '" +
                             repeated + "', which the " + owner + " repeats, other than its Type.");
  if (std::find(taken.begin(), taken.end(), target) != taken.end())
    section.reject(name, name + " must not name a key that another Key of this " + owner +
                             " or the key With of an analysis changes.");
  taken.push_back(target);
}

void declare_grid_keys(parameters::Section &section, const std::string &kind,
                       const std::string &sentence) {
  using namespace parameters;
  section.named_subsection(kind, sentence)
      .text("Tied to", "",
            "Name of another " + kind +
                ": the two change together, so that this one must have as many values and adds no "
                "axis of its own.")
      .text("Path", "", "The key, as for --set: Contact/heads/Clearance, or Variables/lambda.")
      .required()
      .text("Values", "", "Its values, separated by commas.")
      .text("First", "", "First of equally spaced values, instead of Values.")
      .required("Values is not given")
      .text("Last", "", "Last of equally spaced values.")
      .required("Values is not given")
      .integer("Points", "2", Range{.lower = 2, .upper = 1e4}, "",
               "Number of equally spaced values.");
}

void declare_grid(parameters::Section &analysis) {
  parameters::Section &grid = analysis.subsection(
      grid_section, "Repeats another analysis at every combination of the values of some keys.");
  grid.text("Repeat", "", "Name of the analysis to repeat.").required();
  declare_case_table(grid);
  declare_grid_keys(grid, "Key", "A key that takes several values; the last one varies fastest.");
}

std::vector<GridKey> read_grid_keys(const parameters::Values &section, const std::string &kind,
                                    const std::string &repeated, const std::string &owner,
                                    std::vector<std::string> &taken) {
  std::vector<GridKey> keys;
  std::vector<std::string> leaders;
  for (const std::string &name : section.instances(kind))
    if (!section.instance(kind, name).has("Tied to")) {
      keys.push_back(read_key(section.instance(kind, name)));
      keys.back().name = name;
      leaders.push_back(name);
    }
  for (const std::string &name : section.instances(kind))
    if (const parameters::Values key = section.instance(kind, name); key.has("Tied to"))
      attach_follower(key, name, leaders, keys);
  double cases = 1; // whose product may be larger than any integer
  for (const GridKey &key : keys)
    cases *= static_cast<double>(key.values.size());
  if (cases > 1e6)
    section.reject_section("the sections " + kind + " must have at most 1e6 cases, but have " +
                           parameters::number_text(cases));
  for (const GridKey &key : keys) {
    check_changed_key(section.instance(kind, key.name), key.target, repeated, owner, taken);
    for (const GridKey &follower : key.followers)
      check_changed_key(section.instance(kind, follower.name), follower.target, repeated, owner,
                        taken);
  }
  return keys;
}

namespace {

std::vector<GridKey> read_table(const parameters::Values &grid, const std::string &repeated,
                                std::vector<std::string> &taken) {
  if (!grid.instances("Key").empty())
    grid.reject("Cases", "Cases must not be set when there are sections Key.");
  const GridKey key = read_case_table(grid);
  check_changed_key(grid, "Cases", key.target, repeated, "grid", taken);
  for (const GridKey &follower : key.followers)
    check_changed_key(grid, "Cases", follower.target, repeated, "grid", taken);
  return {key};
}

} // namespace

std::vector<GridKey> read_grid(const parameters::Values &analysis, const std::string &repeated,
                               std::vector<std::string> taken) {
  const parameters::Values grid = analysis.subsection(grid_section);
  if (grid.has("Cases"))
    return read_table(grid, repeated, taken);
  std::vector<GridKey> keys = read_grid_keys(grid, "Key", repeated, "grid", taken);
  if (keys.empty())
    grid.reject_section("Cases or at least one subsection Key NAME must be given");
  return keys;
}

std::vector<std::string> grid_paths(const std::vector<GridKey> &keys) {
  std::vector<std::string> paths;
  for (const GridKey &key : keys) {
    paths.push_back(key.path);
    for (const GridKey &follower : key.followers)
      paths.push_back(follower.path);
  }
  return paths;
}

std::string repeated_analysis(const parameters::Values &analysis,
                              const std::vector<std::string> &known) {
  const parameters::Values grid = analysis.subsection(grid_section);
  grid.require("Repeat");
  grid.require_known("Repeat", grid.text("Repeat"), known);
  return grid.text("Repeat");
}

std::size_t grid_size(const std::vector<GridKey> &keys) {
  std::size_t size = 1;
  for (const GridKey &key : keys)
    size *= key.values.size();
  return size;
}

std::vector<std::size_t> grid_index(const std::vector<GridKey> &keys, std::size_t point) {
  std::vector<std::size_t> index(keys.size());
  for (std::size_t k = keys.size(); k-- > 0;) {
    index[k] = point % keys[k].values.size();
    point /= keys[k].values.size();
  }
  return index;
}

std::vector<parameters::Override> grid_overrides(const std::vector<GridKey> &keys,
                                                 std::size_t point) {
  const std::vector<std::size_t> index = grid_index(keys, point);
  std::vector<parameters::Override> overrides;
  const auto set = [&](const GridKey &key, std::size_t position) {
    overrides.push_back({.path = key.path, .value = key.values[position], .origin = key.origin});
  };
  for (std::size_t k = 0; k < keys.size(); ++k) {
    set(keys[k], index[k]);
    for (const GridKey &follower : keys[k].followers)
      set(follower, index[k]);
  }
  return overrides;
}

std::vector<std::size_t> grid_probes(const std::vector<GridKey> &keys) {
  std::vector<std::size_t> points{0};
  std::size_t stride = 1;
  for (std::size_t k = keys.size(); k-- > 0;) {
    // Of very many values, which lie between two ends, a hundred show whether they can be used.
    const std::size_t size = keys[k].values.size();
    const std::size_t step = std::max<std::size_t>(1, size / 100);
    for (std::size_t value = step; value < size; value += step)
      points.push_back(value * stride);
    if ((size - 1) % step != 0)
      points.push_back((size - 1) * stride);
    stride *= size;
  }
  return points;
}

std::string grid_case(const std::vector<GridKey> &keys, std::size_t point) {
  std::vector<std::string> parts;
  for (const parameters::Override &change : grid_overrides(keys, point))
    parts.push_back(change.path + " = " + change.value);
  return parameters::join(parts, ", ");
}

std::vector<Axis> grid_axes(const std::vector<GridKey> &keys,
                            const parameters::ParameterSet &parameters) {
  std::vector<Axis> axes;
  for (const GridKey &key : keys) {
    Axis axis{.name = boost::replace_all_copy(key.path, "/", "."),
              .values = {},
              .labels = {},
              .unit = "1",
              .description = "swept key " + key.path};
    for (const std::string &value : key.values) {
      const auto set = parameters.with({{.path = key.path, .value = value, .origin = key.origin}});
      if (const auto number = set->number_at(key.path)) {
        axis.values.push_back(number->value);
        axis.unit = number->unit;
      }
    }
    if (axis.values.size() != key.values.size()) {
      axis.values.clear();
      axis.labels = key.values;
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

} // namespace vibroimpact::analyses
