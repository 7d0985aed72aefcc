#include "analyses/grid.h"

#include <boost/algorithm/string.hpp>

#include <algorithm>

namespace vibroimpact {

namespace {

constexpr const char *section_name = "Parameter grid";

std::vector<std::string> split_values(const std::string &text) {
  std::vector<std::string> values;
  boost::split(values, text, boost::is_any_of(","));
  for (std::string &value : values)
    boost::trim(value);
  std::erase(values, "");
  return values;
}

// Equally spaced values as expressions of the two ends, so that any unit will do.
std::vector<std::string> between(const std::string &first, const std::string &last, long points) {
  std::vector<std::string> values = {first};
  for (long i = 1; i + 1 < points; ++i)
    values.push_back("(" + first + ") + " + std::to_string(i) + " / " + std::to_string(points - 1) +
                     " * ((" + last + ") - (" + first + "))");
  values.push_back(last);
  return values;
}

GridKey read_key(const parameters::Values &key) {
  key.require("Path");
  GridKey grid_key{.path = key.text("Path"), .values = split_values(key.text("Values"))};
  const bool range = key.has("First") || key.has("Last");
  if (grid_key.values.empty() != range)
    key.reject("Values", "either Values, or First, Last and Points.");
  if (range) {
    key.require("First");
    key.require("Last");
    grid_key.values = between(key.text("First"), key.text("Last"), key.integer("Points"));
  }
  return grid_key;
}

void attach_follower(const parameters::Values &key, const std::vector<std::string> &leaders,
                     std::vector<GridKey> &keys) {
  key.require_known("Follows", key.text("Follows"), leaders);
  const auto found = std::find(leaders.begin(), leaders.end(), key.text("Follows"));
  GridKey &leader = keys[static_cast<std::size_t>(found - leaders.begin())];
  GridKey follower = read_key(key);
  if (follower.values.size() != leader.values.size())
    key.reject(key.has("Values") ? "Values" : "Points",
               std::to_string(leader.values.size()) + " values, as many as the key it follows.");
  leader.followers.push_back(std::move(follower));
}

} // namespace

void declare_grid(parameters::Section &analysis) {
  using namespace parameters;
  Section &grid = analysis.subsection(
      section_name, "Repeats another analysis at every combination of the values of some keys.");
  grid.text("Repeat", "", "Name of the analysis to repeat.");
  grid.named_subsection("Key", "A key that takes several values; the last one varies fastest.")
      .text("Follows", "",
            "Name of another Key: the two change together, so that this one must have as many "
            "values and adds no axis of its own.")
      .text("Path", "", "The key, as for --set: Contact/heads/Clearance, or Variables/lambda.")
      .text("Values", "", "Its values, separated by commas.")
      .text("First", "", "First of equally spaced values, instead of Values.")
      .text("Last", "", "Last of equally spaced values.")
      .integer("Points", "2", Range{.lower = 2, .upper = 1e6}, "",
               "Number of equally spaced values.");
}

std::vector<GridKey> read_grid(const parameters::Values &analysis) {
  const parameters::Values grid = analysis.subsection(section_name);
  std::vector<GridKey> keys;
  std::vector<std::string> leaders;
  for (const std::string &name : grid.instances("Key"))
    if (!grid.instance("Key", name).has("Follows")) {
      keys.push_back(read_key(grid.instance("Key", name)));
      keys.back().name = name;
      leaders.push_back(name);
    }
  if (keys.empty())
    grid.reject_section("a parameter grid needs at least one subsection Key NAME.");
  for (const std::string &name : grid.instances("Key"))
    if (const parameters::Values key = grid.instance("Key", name); key.has("Follows"))
      attach_follower(key, leaders, keys);
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
  const parameters::Values grid = analysis.subsection(section_name);
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
    overrides.push_back(
        {.path = key.path, .value = key.values[position], .origin = "parameter grid"});
  };
  for (std::size_t k = 0; k < keys.size(); ++k) {
    set(keys[k], index[k]);
    for (const GridKey &follower : keys[k].followers)
      set(follower, index[k]);
  }
  return overrides;
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
      const auto set =
          parameters.with({{.path = key.path, .value = value, .origin = "parameter grid"}});
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

} // namespace vibroimpact
