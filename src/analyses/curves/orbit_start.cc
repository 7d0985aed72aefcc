#include "analyses/curves/orbit_start.h"

#include "analyses/curves/first_return.h"
#include "analyses/run/single_point.h"
#include "analyses/run/stored_state.h"
#include "analyses/sweeps/steadiness.h"
#include "common/recorded_step.h"
#include "model/assembled_system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

using periodic::Symmetry;

namespace {

constexpr const char *settling_keys[] = {"Minimum settling cycles", "Settling cycles",
                                         "Steadiness tolerance",    "Settling method",
                                         "Longest period",          "Cycles without approach"};

struct FoundOrbit {
  double phase = 0; ///< of the section [periods]
  long halves = 0;
  Vector state;
  std::vector<double> free_period; ///< periodic::FreePeriod::numbers()
};
void members(auto &visit, As<FoundOrbit> auto &found) {
  visit(found.phase, found.halves, found.state, found.free_period);
}

} // namespace

void declare_orbit_start(parameters::Section &section) {
  using namespace parameters;
  declare_settling(section);
  section.quantities(
      "State", "", dimension::none, range::any, "x_0",
      "State from which Newton's method starts, in SI: as the array `state` of a sweep, "
      "a response or another periodic orbit holds it, at the forcing phase of time "
      "zero. Empty: the motion settles from the initial conditions, or with Settling "
      "cycles = 0 they are the start themselves.",
      0, 100000);
  declare_stored_state(section);
  section.integer(
      "Period multiple", "0", Range{.lower = 0, .upper = 1000}, "p",
      "Forcing periods after which the motion repeats itself, or a multiple of them; 0: "
      "those of the settled motion, 1 where it is not steady yet or a state is given.");
  section.quantity(
      "Period", "0", dimension::time, range::non_negative, "T_0",
      "About the period of a motion that no excitation times, such as that of a belt: where "
      "nothing changes with time the period is found together with the motion. Settling cycles are "
      "of this length, and the first return within twenty of them is where Newton's method starts. "
      "0: the period of the lowest natural frequency.");
}

OrbitStart read_orbit_start(const parameters::Values &section) {
  OrbitStart start{.settling = read_settling(section),
                   .state = section.quantities("State"),
                   .multiple = section.integer("Period multiple"),
                   .period = section.quantity("Period"),
                   .section = section};
  if (section.has("State run") && section.has("State"))
    section.reject("State run", "must not be set when State is set");
  if (start.state.empty())
    start.state = read_stored_state(section);
  for (const char *key : settling_keys)
    if (!start.state.empty() && section.given(key))
      section.reject(key, "must not be set when State or State run is set");
  return start;
}

namespace {

/// [s]; 0: there is no natural frequency.
double longest_natural_period(const model::Model &model) {
  if (model.size() == 0)
    return 0;
  for (const double square : assembled_modes(model, model::AssembledSystem(model)).stiffness)
    if (square > 0)
      return 2 * std::numbers::pi / std::sqrt(square);
  return 0;
}

} // namespace

std::string rigid_body_cause(const System &system) {
  const std::string unheld = model::unheld_motions(system.model);
  return unheld.empty() ? ""
                        : unheld + ": unless a contact does, its periodic motions have a "
                                   "multiplier of 1 and are not isolated, so that none can be "
                                   "found or followed";
}

NumericalError no_orbit(const System &system, const NumericalError &why) {
  return NumericalError(why.what() + rigid_body_cause(system));
}

void run_orbit_point(const System &system, LineContext &context,
                     const std::function<PointResult()> &compute) {
  run_single_point(context, [&] {
    try {
      return compute();
    } catch (const NumericalError &error) {
      throw no_orbit(system, error);
    }
  });
}

motion::VariationAccuracy orbit_accuracy(const System &system,
                                         const periodic::ForcedSystem &forced) {
  return {.scale = deviation_scale(forced.equations(), 2 * std::numbers::pi / forced.period()),
          .tolerance = std::min(1e-10, system.integration.relative_tolerance)};
}

namespace {

periodic::ForcedSystem periodic_system(const System &system, std::optional<std::size_t> source,
                                       const OrbitStart &start) {
  if (source)
    return {system.model, system.contacts, system.integration, *source};
  auto free = std::make_shared<periodic::FreePeriod>(
      start.period > 0 ? start.period : longest_natural_period(system.model));
  if (!(free->period() > 0))
    start.section.value().reject("Period", "must be given: the model has no natural frequency");
  return {system.model, system.contacts, system.integration, std::move(free)};
}

} // namespace

OrbitSearch::OrbitSearch(const System &system, std::optional<std::size_t> source,
                         const OrbitStart &start)
    : system_(system), start_(start), forced_(periodic_system(system, source, start)) {
  const auto size = static_cast<std::size_t>(forced_.layout().physical_size());
  if (!start.state.empty() && start.state.size() != size)
    start.section.value().reject(
        start.section->has("State") ? "State" : "State run",
        "must have " + std::to_string(size) +
            " numbers: coordinates, their rates, internal states of contacts; or none");
}

// Without forcing the motion is only let go on: it repeats itself after no time that is known.
OrbitSearch::FirstState
OrbitSearch::first_state(const std::function<void(long periods)> &after_period) {
  FirstState first = settled_state(after_period);
  if (free_period()) {
    first.multiple = 1;
    first.period = first_return(forced_, first.state, scale_);
  }
  return first;
}

OrbitSearch::FirstState
OrbitSearch::settled_state(const std::function<void(long periods)> &after_period) {
  if (!start_.state.empty())
    return {.state = ConstVectorView(start_.state.data(), static_cast<Index>(start_.state.size()))};
  motion::Trajectory &trajectory = forced_.trajectory();
  trajectory.start(0, system_.initial.displacement, system_.initial.velocity);
  SettlingRule rule = start_.settling;
  if (free_period()) {
    rule.newton_after.reset();
    rule.without_approach = 0;
  }
  const SettledMotion settled = Settler(trajectory)(forced_.period(), scale_, rule, after_period);
  if (start_.settling.maximum > 0 && !free_period())
    settled_multiple_ = settled.multiple;
  return {.state = settled.state.physical,
          .multiple = std::max(1L, settled.multiple),
          .cycles = settled.cycles};
}

periodic::Orbit OrbitSearch::run(const std::function<void(long periods)> &after_period,
                                 StepRecord *steps) {
  motion::VariationAccuracy accuracy = orbit_accuracy(system_, forced_);
  scale_ = accuracy.scale;
  const FirstState first =
      recorded(steps, "settled motion", [&] { return first_state(after_period); });
  cycles_ = first.cycles;
  if (free_period())
    free_period()->set_period(first.period);
  const double size = first.state.cwiseProduct(scale_).cwiseAbs().maxCoeff();
  map_.emplace(forced_, std::move(accuracy), Symmetry::find(forced_, scale_, size > 0 ? size : 1));
  const long multiple = start_.multiple > 0 ? start_.multiple : first.multiple;
  if (steps == nullptr)
    return find_orbit(*map_, multiple, first.state);
  const FoundOrbit found = recorded(steps, "orbit", [&] {
    const periodic::Orbit orbit = find_orbit(*map_, multiple, first.state);
    return FoundOrbit{orbit.section.phase, orbit.section.halves, orbit.point.state,
                      free_period() ? free_period()->numbers() : std::vector<double>{}};
  });
  if (free_period())
    free_period()->restore(found.free_period);
  return {.section = {.phase = found.phase, .halves = found.halves},
          .point = {.state = found.state, .image = {}}};
}

} // namespace vibroimpact::analyses
