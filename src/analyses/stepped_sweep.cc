#include "analyses/stepped_sweep.h"

#include "analyses/fields.h"
#include "analyses/steadiness.h"
#include "analyses/window_recording.h"
#include "common/error.h"

#include <cmath>
#include <numbers>

namespace vibroimpact {

namespace {

constexpr const char *section_name = "Stepped sweep";

std::vector<double> spaced(double first, double last, long points, bool logarithmic) {
  std::vector<double> values;
  for (long i = 0; i < points; ++i) {
    const double share = points > 1 ? static_cast<double>(i) / static_cast<double>(points - 1) : 0;
    values.push_back(logarithmic ? first * std::pow(last / first, share)
                                 : first + (last - first) * share);
  }
  return values;
}

SteppedSweep::Directions parse_directions(const std::string &name) {
  if (name == "forward")
    return SteppedSweep::Directions::forward;
  return name == "backward" ? SteppedSweep::Directions::backward : SteppedSweep::Directions::both;
}

Field state_field(const Vector &physical) {
  return series_field("state", "state", {physical.begin(), physical.end()}, "SI",
                      "state at the end: coordinates, their rates, internal states of contacts");
}

Vector stored_state(const PointResult &result) {
  for (const Field &field : result.fields)
    if (field.name == "state")
      return ConstVectorView(field.values.data(), static_cast<Index>(field.values.size()));
  return {};
}

} // namespace

/// One point of a line: its place along the axes.
struct SteppedSweep::Step {
  std::size_t direction = 0;
  std::size_t frequency = 0;
  bool from_rest = false;

  std::vector<std::size_t> index() const { return {frequency, direction}; }
};

void SteppedSweep::declare(parameters::Section &analysis) {
  using namespace parameters;
  analysis
      .subsection(section_name, "Stepped sine sweep: settles at each frequency, then records; the "
                                "state is carried to the next one at forcing phase zero.")
      .quantity("First frequency", "", dimension::frequency, range::positive, "f_1",
                "Lowest frequency.")
      .quantity("Last frequency", "", dimension::frequency, range::positive, "f_2",
                "Highest frequency.")
      .integer("Points", "50", Range{.lower = 1, .upper = 1e7}, "", "Number of frequencies.")
      .choice("Spacing", "linear", {"linear", "logarithmic"}, "How the frequencies are spaced.")
      .choice("Direction", "both", {"forward", "backward", "both"},
              "Rising, falling, or rising and then falling frequency.")
      .choice("Backward start", "forward end", {"forward end", "initial conditions"},
              "Where the backward sweep of a pair starts. From the initial conditions, the two run "
              "independently of each other.")
      .text("Excitation", "", "Excitation whose frequency is swept; empty when there is only one.")
      .integer("Minimum settling cycles", "5", Range{.lower = 0}, "",
               "Periods before the motion can be judged steady.")
      .integer("Settling cycles", "200", Range{.lower = 0}, "",
               "Periods after which it is recorded, steady or not.")
      .integer("Recorded cycles", "10", Range{.lower = 1}, "", "Periods of the recorded window.")
      .quantity("Steadiness tolerance", "1e-6", dimension::none, Range{.lower = 0, .upper = 1}, "",
                "Relative distance to the periodic motion at which it counts as steady; 0 always "
                "takes all settling cycles.")
      .integer("Longest period", "4", Range{.lower = 1, .upper = 1000}, "",
               "Longest period looked for, in forcing periods.");
}

std::shared_ptr<const Analysis> SteppedSweep::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(section_name);
  values.require("First frequency");
  values.require("Last frequency");
  const double first = values.quantity("First frequency") / (2 * std::numbers::pi);
  const double last = values.quantity("Last frequency") / (2 * std::numbers::pi);
  const long points = values.integer("Points");
  if (last < first || (last == first && points > 1))
    values.reject("Last frequency", "a frequency above First frequency.");
  if (values.integer("Minimum settling cycles") > values.integer("Settling cycles"))
    values.reject("Minimum settling cycles", "at most Settling cycles.");
  return std::make_shared<SteppedSweep>(
      Settings{.frequencies = spaced(first, last, points, values.choice("Spacing") != "linear"),
               .directions = parse_directions(values.choice("Direction")),
               .backward_from_rest = values.choice("Backward start") == "initial conditions",
               .minimum_settling = values.integer("Minimum settling cycles"),
               .maximum_settling = values.integer("Settling cycles"),
               .recorded = values.integer("Recorded cycles"),
               .steadiness = values.quantity("Steadiness tolerance"),
               .longest_multiple = values.integer("Longest period"),
               .excitation = values.text("Excitation"),
               .recorders = read_recorders(analysis, {"excursions", "impacts"})});
}

std::vector<Axis> SteppedSweep::axes() const {
  std::vector<std::string> directions;
  if (settings_.directions != Directions::backward)
    directions.emplace_back("forward");
  if (settings_.directions != Directions::forward)
    directions.emplace_back("backward");
  return {{.name = "frequency",
           .values = settings_.frequencies,
           .labels = {},
           .unit = "Hz",
           .description = "excitation frequency"},
          {.name = "direction",
           .values = {},
           .labels = directions,
           .unit = "1",
           .description = "direction of the sweep"}};
}

std::size_t SteppedSweep::lines() const {
  return settings_.directions == Directions::both && settings_.backward_from_rest ? 2 : 1;
}

std::vector<SteppedSweep::Step> SteppedSweep::steps_of_line(std::size_t line) const {
  const std::size_t points = settings_.frequencies.size();
  const bool both = settings_.directions == Directions::both;
  std::vector<Step> steps;
  const bool forward = settings_.directions != Directions::backward && line == 0;
  const bool backward = settings_.directions == Directions::backward ||
                        (both && (line == 1 || !settings_.backward_from_rest));
  for (std::size_t i = 0; forward && i < points; ++i)
    steps.push_back({.direction = 0, .frequency = i, .from_rest = i == 0});
  for (std::size_t i = 0; backward && i < points; ++i)
    steps.push_back({.direction = both ? 1u : 0u,
                     .frequency = points - 1 - i,
                     .from_rest = i == 0 && !forward});
  return steps;
}

Workload SteppedSweep::workload(const System & /*system*/) const {
  Workload work{.simulated_time = 0, .points = steps_of_line(0).size()};
  const double cycles = static_cast<double>(settings_.maximum_settling + settings_.recorded);
  for (const Step &step : steps_of_line(0))
    work.simulated_time += cycles / settings_.frequencies[step.frequency];
  return work;
}

std::size_t SteppedSweep::swept_source(const System &system) const {
  const std::vector<Source> &sources = system.model.sources();
  if (settings_.excitation.empty() && sources.size() == 1)
    return 0;
  return system.model.find_source(settings_.excitation);
}

void SteppedSweep::check(const System &system) const {
  const std::size_t source = swept_source(system);
  if (source == system.model.sources().size())
    throw InputError(settings_.excitation.empty()
                         ? "A stepped sweep needs one excitation, or the key Excitation that says "
                           "which of several is swept."
                         : "The swept excitation " + settings_.excitation +
                               " is not among the active ones.");
  const Source &swept = system.model.sources()[source];
  if (!swept.function->with_frequency(1))
    throw InputError("The swept excitation " + swept.name +
                     " has no frequency that a stepped sweep could change; its History must be "
                     "harmonic or ramped harmonic.");
  Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  const WindowRecording recording(settings_.recorders, system);
}

PointResult SteppedSweep::compute(const Step &step, System &system, Trajectory &trajectory,
                                  const MotionState &from) const {
  const double frequency = settings_.frequencies[step.frequency];
  const double period = 1 / frequency;
  WindowRecording recording(settings_.recorders, system);
  Observers nobody({});
  Steadiness steadiness(state_scale(trajectory.equations(), 2 * std::numbers::pi * frequency),
                        settings_.longest_multiple, settings_.steadiness);
  PointResult result{.index = step.index()};
  trajectory.start(from);
  long cycles = 0;
  while (cycles < settings_.maximum_settling &&
         !(cycles >= settings_.minimum_settling && steadiness.steady())) {
    ++cycles;
    trajectory.advance(static_cast<double>(cycles) * period, nobody);
    steadiness.add(trajectory.motion_state().physical);
  }
  recording.run(periods_window(static_cast<double>(cycles) * period, period, settings_.recorded),
                trajectory);

  recording.add_fields(result);
  result.fields.push_back(scalar_field("steady", steadiness.steady() ? 1 : 0, "1",
                                       "1 when the motion was judged steady before recording"));
  result.fields.push_back(scalar_field("period_multiple",
                                       static_cast<double>(steadiness.multiple()), "1",
                                       "forcing periods after which it repeats, 0 unknown"));
  result.fields.push_back(scalar_field("settling_cycles", static_cast<double>(cycles), "1",
                                       "forcing periods before recording"));
  result.fields.push_back(state_field(trajectory.motion_state().physical));
  add_accuracy(result, trajectory.accuracy(), system.integration);
  return result;
}

void SteppedSweep::run_line(std::size_t line, System &system, LineContext &context) const {
  Trajectory trajectory(system.model, system.contacts, system.integration);
  const std::size_t source = swept_source(system);
  MotionState from;
  for (const Step &step : steps_of_line(line)) {
    system.model.set_frequency(source,
                               2 * std::numbers::pi * settings_.frequencies[step.frequency]);
    if (step.from_rest) {
      trajectory.start(0, system.initial.displacement, system.initial.velocity);
      from = trajectory.motion_state();
    }
    if (const PointResult *known = context.find(step.index())) {
      if (known->status == Status::finished)
        from = {.time = 0, .physical = stored_state(*known)};
      context.skip();
      continue;
    }
    try {
      PointResult result = compute(step, system, trajectory, from);
      from = {.time = 0, .physical = trajectory.motion_state().physical};
      context.store(std::move(result));
    } catch (const NumericalError &error) {
      // The next frequency goes on from where this one started.
      context.store({.index = step.index(), .status = Status::failed, .reason = error.what()});
    }
  }
}

} // namespace vibroimpact
