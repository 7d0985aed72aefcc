#include "analyses/keys/branch_keys.h"

#include "analyses/keys/keyed_system.h"
#include "common/error.h"

#include <algorithm>

namespace vibroimpact::analyses {

void declare_branch_keys(parameters::Section &section) {
  declare_key_range(section);
  section.choice("Direction", "both", {"both", "forward", "backward"},
                 "Where the branch is followed from its start: with the key rising at first, "
                 "falling, or both.");
  declare_steps(section, "branch");
}

void declare_steps(parameters::Section &section, const std::string &curve,
                   const std::string &longest) {
  using namespace parameters;
  section
      .integer("Most points", "1000", Range{.lower = 2, .upper = 1e6}, "",
               "Points in each direction, after which it ends.")
      .quantity(
          "Longest step", longest, dimension::none,
          Range{.lower = 0, .upper = 1, .lower_open = true}, "",
          "Longest distance between neighbouring points, each key counted in its range and the "
          "state in the size of the motion; 0.03 to 0.05 for stiff contacts.")
      .quantity("Least step", "1e-9", dimension::none,
                Range{.lower = 0, .upper = 0.01, .lower_open = true}, "",
                "Where shorter steps would be needed the " + curve + " ends.");
}

Directions read_direction(const parameters::Values &section) {
  const std::string name = section.choice("Direction");
  if (name == "both")
    return Directions::both;
  return name == "forward" ? Directions::forward : Directions::backward;
}

double read_start(const SweptParameter &parameter, const parameters::Values &section) {
  if (parameter.is_frequency())
    return 0;
  const auto number = section.parameters().number_at(parameter.path);
  if (!number)
    section.reject("Parameter",
                   "must be a key with one number as its value, at which the branch begins");
  return number->value;
}

continuation::Range range_of(const SweptParameter &parameter) {
  return {.lower = parameter.values.front(), .upper = parameter.values.back()};
}

continuation::Settings read_continuation(const parameters::Values &section,
                                         const SweptParameter &parameter) {
  continuation::Settings settings = read_steps(section);
  settings.first_key = range_of(parameter);
  return settings;
}

continuation::Settings read_steps(const parameters::Values &section) {
  continuation::Settings settings;
  settings.most_points = static_cast<int>(section.integer("Most points"));
  settings.longest_step = section.quantity("Longest step");
  settings.least_step = section.quantity("Least step");
  settings.first_step = std::min(settings.first_step, settings.longest_step);
  if (settings.least_step >= settings.first_step)
    section.reject("Least step", "must be less than Longest step and less than 0.01");
  return settings;
}

double start_value(const SweptParameter &parameter, double read, const System &system,
                   const std::string &excitation, const std::string &who) {
  if (!parameter.is_frequency())
    return read;
  const std::size_t source = sweep_source(system, excitation, who);
  return 1 / system.model.sources()[source].function->period();
}

void check_start(const SweptParameter &parameter, double read, const System &system,
                 const std::string &excitation, const std::string &who) {
  const double value = start_value(parameter, read, system, excitation, who);
  const double first = parameter.values.front(), last = parameter.values.back();
  if (value < first || value > last)
    throw InputError(who + " begins at the value that the file gives to its key, " +
                     std::to_string(value) + " " + parameter.unit +
                     ", which must lie between its ends, " + std::to_string(first) + " and " +
                     std::to_string(last) + " " + parameter.unit + ".");
  if (!parameter.is_frequency())
    return;
  const model::Source &source = system.model.sources()[sweep_source(system, excitation, who)];
  if (!source.function->with_frequency(1))
    throw InputError("The excitation " + source.name +
                     " has no frequency that a branch could change; its History must be harmonic.");
}

std::vector<std::vector<parameters::Override>> end_variants(const SweptParameter &parameter) {
  if (parameter.is_frequency())
    return {};
  return {{parameter.at(parameter.values.front())}, {parameter.at(parameter.values.back())}};
}

} // namespace vibroimpact::analyses
