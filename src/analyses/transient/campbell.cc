#include "analyses/transient/campbell.h"

#include "analyses/results/field_writer.h"
#include "analyses/run/single_point.h"
#include "analyses/transient/whirl_branches.h"
#include "common/error.h"
#include "common/log.h"

#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

constexpr const char *campbell_section = "Campbell";
constexpr double radians_per_cycle = 2 * std::numbers::pi;

/// One row for each mode, one column for each speed; NaN where a mode does not vibrate.
template <class Value> Matrix table(const WhirlBranches &branches, const Value &value) {
  Matrix numbers(static_cast<Index>(branches.modes()),
                 static_cast<Index>(branches.speeds().size()));
  for (Index j = 0; j < numbers.rows(); ++j)
    for (Index k = 0; k < numbers.cols(); ++k) {
      const auto &state = branches.state(static_cast<std::size_t>(k), static_cast<std::size_t>(j));
      numbers(j, k) = state ? value(*state, branches.speeds()[static_cast<std::size_t>(k)])
                            : std::numeric_limits<double>::quiet_NaN();
    }
  return numbers;
}

double hertz(const WhirlState &state) { return state.eigenvalue.imag() / radians_per_cycle; }

double damping_ratio(const WhirlState &state) {
  return -state.eigenvalue.real() / std::abs(state.eigenvalue);
}

/// The model turns at `present`, to which its whirl numbers refer. At rest there is no direction.
struct WhirlDirection {
  const model::Model &model;
  double present = 0; ///< [rad/s]

  double at(double speed, const WhirlState &state) const {
    const double number = model::whirl_numbers(model, state.shape)[0];
    const bool against = (speed < 0) != (present < 0);
    return speed == 0 ? 0 : against ? -number : number;
  }
};

void add_tables(const FieldWriter &of, const WhirlDirection &whirl, const WhirlBranches &branches) {
  of.series("speed", "speed", branches.speeds(), "rad/s", "speed of the spin");
  const auto add = [&](const char *name, const char *unit, const char *description,
                       const auto &value) {
    of.array(Label(name, unit, description, {"whirl_mode", "speed"}), table(branches, value));
  };
  add("frequency", "Hz", "frequency of each mode",
      [](const WhirlState &state, double /*speed*/) { return hertz(state); });
  add("decay_rate", "1/s", "rate at which it decays; negative: it grows",
      [](const WhirlState &state, double /*speed*/) { return -state.eigenvalue.real(); });
  add("damping_ratio", "1", "share of the decay rate in the size of the eigenvalue",
      [](const WhirlState &state, double /*speed*/) { return damping_ratio(state); });
  add("whirl", "1", "1: forward whirl in circles, -1: backward, 0: to and fro, or at rest",
      [&](const WhirlState &state, double speed) { return whirl.at(speed, state); });
}

std::string direction_name(double whirl) {
  constexpr double to_and_fro = 1e-6;
  return whirl > to_and_fro ? "forward" : whirl < -to_and_fro ? "backward" : "to and fro";
}

/// Speeds at which something is true of a mode, in the folder `name`.
void add_speeds(const FieldWriter &of, const std::string &name, const std::string &meaning,
                const WhirlDirection &whirl, const std::vector<WhirlSpeed> &list) {
  const auto add = [&](const char *quantity, const char *unit, const std::string &description,
                       const auto &value) {
    std::vector<double> values;
    for (const WhirlSpeed &one : list)
      values.push_back(value(one));
    of.series(name + "/" + quantity, name + "_speed", values, unit, description);
  };
  add("speed", "rad/s", "speed at which " + meaning,
      [](const WhirlSpeed &one) { return one.speed; });
  add("mode", "1", "number of the mode, from 1",
      [](const WhirlSpeed &one) { return static_cast<double>(one.mode + 1); });
  add("frequency", "Hz", "frequency there", [](const WhirlSpeed &one) { return hertz(one.state); });
  add("damping_ratio", "1", "damping there",
      [](const WhirlSpeed &one) { return damping_ratio(one.state); });
  add("whirl", "1", "1: forward whirl in circles, -1: backward, 0: to and fro",
      [&](const WhirlSpeed &one) { return whirl.at(one.speed, one.state); });
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string place = name + "[" + std::to_string(k + 1) + "]";
    const double number = whirl.at(list[k].speed, list[k].state);
    of.line(place + ".speed", list[k].speed, "rad/s");
    of.line(place + ".whirl", number, "1");
    log::info(name + " speed " + std::to_string(list[k].speed) + " rad/s of mode " +
              std::to_string(list[k].mode + 1) + ", " + direction_name(number));
  }
}

void add_critical(const FieldWriter &of, const WhirlDirection &whirl, const WhirlBranches &branches,
                  const std::vector<double> &multiples) {
  std::vector<WhirlSpeed> list;
  std::vector<double> of_each;
  for (const double multiple : multiples)
    for (WhirlSpeed &critical : branches.critical(multiple)) {
      list.push_back(std::move(critical));
      of_each.push_back(multiple);
    }
  add_speeds(of, "critical", "a frequency is a multiple of it", whirl, list);
  of.series("critical/multiple", "critical_speed", of_each, "1", "frequency over speed");
}

std::vector<double> equally_spaced(double first, double last, long points) {
  std::vector<double> values;
  for (long i = 0; i < points; ++i)
    values.push_back(first +
                     (last - first) * static_cast<double>(i) / static_cast<double>(points - 1));
  return values;
}

} // namespace

void Campbell::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      campbell_section, "Modes of the whole linear system over the speed of a Spin, and its "
                        "critical speeds.");
  section.text("Spin", "", "Whose speed changes; empty when there is only one.")
      .quantity("First speed", "0 rad/s", dimension::frequency, range::any, "", "Lowest speed.")
      .quantity("Last speed", "", dimension::frequency, range::any, "", "Highest speed.")
      .required()
      .integer("Points", "101", Range{.lower = 2, .upper = 1e5}, "", "Number of speeds.")
      .integer("Modes", "8", Range{.lower = 1, .upper = 1e4}, "",
               "The lowest ones at the first speed, which are followed; with all of the last "
               "frequency.")
      .quantities("Multiples", "1", dimension::none, range::positive, "n",
                  "Critical speeds are those where a frequency is n times the speed: 1 for an "
                  "unbalance.",
                  1, 100);
  declare_tied_contacts(section);
}

std::shared_ptr<const Analysis> Campbell::create(const parameters::Values &analysis) {
  const parameters::Values section = analysis.subsection(campbell_section);
  section.require("Last speed");
  const double first = section.quantity("First speed");
  const double last = section.quantity("Last speed");
  if (!(last > first))
    section.reject("Last speed", "must be greater than First speed");
  return std::make_shared<Campbell>(
      Settings{.spin = section.text("Spin"),
               .speeds = equally_spaced(first, last, section.integer("Points")),
               .modes = static_cast<std::size_t>(section.integer("Modes")),
               .multiples = section.quantities("Multiples"),
               .tied = read_tied_contacts(section)});
}

std::size_t Campbell::spin(const System &system) const {
  const std::vector<model::Spin> &spins = system.model.spins();
  if (settings_.spin.empty() && spins.size() == 1)
    return 0;
  for (std::size_t s = 0; s < spins.size(); ++s)
    if (spins[s].name == settings_.spin)
      return s;
  throw InputError(spins.empty() ? "A Campbell diagram must have a section Spin: nothing turns."
                   : settings_.spin.empty()
                       ? "A Campbell diagram must name its Spin, for there are several."
                       : "A Campbell diagram must name a Spin of the file; there is no " +
                             settings_.spin + ".");
}

void Campbell::check(const System &system) const {
  if (!system.model.rotors().empty())
    throw InputError("A Campbell diagram must have a model without bodies of Type = rotor, whose "
                     "mass changes as they turn.");
  spin(system);
  settings_.tied(system);
}

PointResult Campbell::compute(const System &system) const {
  PointResult point;
  const FieldWriter result(point);
  const model::AssembledSystem assembled(system.model,
                                         rows_of(settings_.tied(system), system.model.size()));
  const model::WhirlingSystem whirling(system.model, assembled, spin(system));
  const WhirlBranches branches(whirling, settings_.speeds, settings_.modes);
  const WhirlDirection direction{.model = system.model,
                                 .present = system.model.spins()[spin(system)].speed.at(0)};
  add_tables(result, direction, branches);
  add_critical(result, direction, branches, settings_.multiples);
  add_speeds(result, "threshold", "a mode begins to grow or to decay", direction,
             branches.thresholds());
  return point;
}

void Campbell::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system); });
}

} // namespace vibroimpact::analyses
