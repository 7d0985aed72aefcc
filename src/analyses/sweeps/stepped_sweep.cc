#include "analyses/sweeps/stepped_sweep.h"

#include "analyses/keys/swept_system.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/results/fields.h"
#include "common/error.h"

#include <optional>

namespace vibroimpact::analyses {

using motion::MotionState;

namespace {

constexpr const char *stepped_sweep_section = "Stepped sweep";
constexpr const char *state = "state";
constexpr const char *lowest_state = "settled_state_minimum";
constexpr const char *highest_state = "settled_state_maximum";
constexpr std::size_t usual_fields = 64; // of a point; with more its list grows once

SteppedSweep::Directions read_directions(const parameters::Values &values) {
  const std::string name = values.choice("Direction");
  if (values.choice("Start") == "initial conditions") {
    for (const char *key : {"Direction", "Backward start"})
      if (values.given(key))
        values.reject(
            key,
            "must not be set when Start = initial conditions, with which no state is carried over");
    return SteppedSweep::Directions::independent;
  }
  if (name == "forward")
    return SteppedSweep::Directions::forward;
  return name == "backward" ? SteppedSweep::Directions::backward : SteppedSweep::Directions::both;
}

Label state_label(const char *name, const std::string &description) {
  return {name,
          "SI",
          description + ": coordinates, their rates, internal states of contacts, torques of "
                        "motors",
          {state_dimension}};
}

Vector stored_state(const PointResult &result, const char *name) {
  const Field *field = find(result, name);
  return field == nullptr
             ? Vector()
             : ConstVectorView(field->values.data(), static_cast<Index>(field->values.size()));
}

// What find_jump() needs of a point that an earlier run finished.
SettledMotion stored_motion(const PointResult &result) {
  SettledMotion motion;
  motion.state.physical = stored_state(result, state);
  motion.lowest = stored_state(result, lowest_state);
  motion.highest = stored_state(result, highest_state);
  motion.multiple = static_cast<long>(number_of(result, "period_multiple", 0));
  return motion;
}

void add_settling(const FieldWriter &result, const SettledMotion &settled) {
  static const Label end_state = state_label(state, "state at the end");
  add_settled(result, settled.steady(), settled.multiple, settled.cycles);
  result.array(end_state, settled.state.physical);
}

void add_jump(const FieldWriter &result, const Jump &jump, const SettledMotion &settled,
              const std::string &unit) {
  static const Label lowest = state_label(lowest_state, "smallest state at the ends of periods");
  static const Label highest = state_label(highest_state, "largest state at the ends of periods");
  result.array(lowest, settled.lowest);
  result.array(highest, settled.highest);
  result.number(
      "jump_from", jump.from, unit,
      "last value at which the motion, settled for as long as the sweep lets it, is still near the "
      "branch that it comes from, between the previous point of the sweep and this one; NaN "
      "without a jump. It is where the settled motion jumps and no bound of the fold behind it, "
      "which a branch or locus gives");
  result.number(
      "jump_to", jump.to, unit,
      "first value at which the motion settled in that way has left the branch; NaN without one");
  if (jump.found()) {
    result.line("jump_from", jump.from, unit);
    result.line("jump_to", jump.to, unit);
  }
}

} // namespace

/// One point of a line: its place along the axes.
struct SteppedSweep::Step {
  std::size_t direction = 0;
  std::size_t point = 0;
  bool from_rest = false;

  std::vector<std::size_t> index() const { return {point, direction}; }
};

void SteppedSweep::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      stepped_sweep_section,
      "Settles at each frequency, or each value of another key, then records; the "
      "state is carried to the next one at the forcing phase of time zero.");
  declare_swept_parameter(section);
  section
      .choice("Start", "carried over", {"carried over", "initial conditions"},
              "What a point starts from: the end of the point before it, or the initial "
              "conditions, each point then being independent of the others.")
      .choice("Direction", "both", {"forward", "backward", "both"},
              "Rising, falling, or rising and then falling frequency or value.")
      .choice("Backward start", "forward end", {"forward end", "initial conditions"},
              "Where the backward sweep of a pair starts. From the initial conditions, the two run "
              "independently of each other.")
      .text("Excitation", "",
            "Excitation whose frequency is swept or whose period is that of the motion; empty when "
            "there is only one with a period.");
  declare_settling(section);
  section
      .integer("Recorded cycles", "10", Range{.lower = 1, .upper = 1e9}, "",
               "Periods of the recorded window.")
      .quantity("Jump tolerance", "0", dimension::none, Range{.lower = 0, .upper = 0.1}, "",
                "Width, relative to the largest swept value, to which the bracket of each jump of "
                "the response between two points is narrowed, by motions that settle as those of "
                "the sweep do; 0: jumps are not looked for. Transients near a fold last ever "
                "longer, so that the fold may lie outside of the bracket.")
      .quantity("Jump threshold", "0.05", dimension::none,
                Range{.lower = 0, .upper = 1, .lower_open = true}, "",
                "Change of the state, relative to its size, from which on a discontinuity counts "
                "as a jump.");
}

std::shared_ptr<const Analysis> SteppedSweep::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(stepped_sweep_section);
  Settings settings{.parameter = read_swept_parameter(values),
                    .directions = read_directions(values),
                    .backward_from_rest = values.choice("Backward start") == "initial conditions",
                    .settling = read_settling(values),
                    .recorded = values.integer("Recorded cycles"),
                    .excitation = values.text("Excitation"),
                    .jump_tolerance = values.quantity("Jump tolerance"),
                    .jump_threshold = values.quantity("Jump threshold"),
                    .recorders = read_recorders(analysis, {"extreme values", "impacts"})};
  if (settings.jump_tolerance > 0 && settings.directions == Directions::independent)
    values.reject("Jump tolerance",
                  "must be 0 when Start = initial conditions, with which no state is carried over");
  return std::make_shared<SteppedSweep>(std::move(settings));
}

std::vector<Axis> SteppedSweep::axes() const {
  std::vector<std::string> directions;
  if (settings_.directions == Directions::forward || settings_.directions == Directions::both)
    directions.emplace_back("forward");
  if (settings_.directions == Directions::backward || settings_.directions == Directions::both)
    directions.emplace_back("backward");
  if (settings_.directions == Directions::independent)
    directions.emplace_back("initial conditions");
  return {settings_.parameter.axis(),
          {.name = "direction",
           .values = {},
           .labels = directions,
           .unit = "1",
           .description = "direction of the sweep, or what every point starts from"}};
}

std::size_t SteppedSweep::lines() const {
  if (settings_.directions == Directions::independent)
    return settings_.parameter.values.size();
  return settings_.directions == Directions::both && settings_.backward_from_rest ? 2 : 1;
}

std::vector<SteppedSweep::Step> SteppedSweep::steps_of_line(std::size_t line) const {
  if (settings_.directions == Directions::independent)
    return {{.direction = 0, .point = line, .from_rest = true}};
  const std::size_t points = settings_.parameter.values.size();
  const bool both = settings_.directions == Directions::both;
  std::vector<Step> steps;
  const bool forward = settings_.directions != Directions::backward && line == 0;
  const bool backward = settings_.directions == Directions::backward ||
                        (both && (line == 1 || !settings_.backward_from_rest));
  for (std::size_t i = 0; forward && i < points; ++i)
    steps.push_back({.direction = 0, .point = i, .from_rest = i == 0});
  for (std::size_t i = 0; backward && i < points; ++i)
    steps.push_back(
        {.direction = both ? 1u : 0u, .point = points - 1 - i, .from_rest = i == 0 && !forward});
  return steps;
}

void SteppedSweep::check(const System &system) const {
  const model::Source &swept = system.model.sources()[sweep_source(system, settings_.excitation)];
  if (settings_.parameter.is_frequency() && !swept.function->with_frequency(1))
    throw InputError("The swept excitation " + swept.name +
                     " has no frequency that a stepped sweep could change; its History must be "
                     "harmonic or ramped harmonic.");
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  const WindowRecording recording(settings_.recorders, system);
}

std::vector<std::vector<parameters::Override>> SteppedSweep::variants() const {
  std::vector<std::vector<parameters::Override>> overrides;
  for (const double value : settings_.parameter.values)
    if (!settings_.parameter.is_frequency())
      overrides.push_back({settings_.parameter.at(value)});
  return overrides;
}

// Of at most so many periods; the search for a jump has no share of its own.
void SteppedSweep::note(long periods, LineContext &context) const {
  context.note_progress(static_cast<double>(periods) /
                        static_cast<double>(settings_.settling.maximum + settings_.recorded));
}

PointResult SteppedSweep::compute(const Step &step, SweptSystem &swept, const MotionState &from,
                                  SettledMotion &settled, LineContext &context) const {
  const System &system = swept.system();
  motion::Trajectory &trajectory = swept.trajectory();
  WindowRecording &recording = swept.recording();
  PointResult result{.index = step.index()};
  result.fields.reserve(usual_fields);
  result.summary.reserve(usual_fields);
  trajectory.start(from);
  settled = swept.settler()(swept.period(), swept.scale(), settings_.settling,
                            [&](long periods) { note(periods, context); });
  recording.run(periods_window(static_cast<double>(settled.cycles) * swept.period(), swept.period(),
                               settings_.recorded),
                trajectory, [&](long period) { note(settled.cycles + period, context); });
  settled.state = {.time = 0, .physical = trajectory.motion_state().physical};

  recording.add_fields(result);
  add_settling(result, settled);
  add_accuracy(result, trajectory.accuracy(), system.integration);
  return result;
}

Jump SteppedSweep::search(const BranchPoint &before, const BranchPoint &after, SweptSystem &swept,
                          LineContext &context) const {
  const Vector scale = swept.scale();
  const double width = settings_.jump_tolerance * settings_.parameter.magnitude();
  return find_jump(
      before, after, width, settings_.jump_threshold,
      [&](double value, const MotionState &from) {
        swept.move_to(value);
        swept.trajectory().start(from);
        return swept.settler()(swept.period(), swept.scale(), settings_.settling,
                               [&](long /*periods*/) { context.note_progress(0); });
      },
      [&](const SettledMotion &a, const SettledMotion &b) {
        return relative_distance(a, b, scale);
      });
}

// The point of one step, with the jump on the way to it; `before` and `from` move on to it.
PointResult SteppedSweep::advance(const Step &step, SweptSystem &swept, MotionState &from,
                                  std::optional<BranchPoint> &before, LineContext &context) const {
  const double value = settings_.parameter.values[step.point];
  swept.move_to(value);
  if (step.from_rest || from.physical.size() == 0) {
    const model::InitialState &initial = swept.system().initial;
    swept.trajectory().start(0, initial.displacement, initial.velocity);
    from = swept.trajectory().motion_state();
  }
  BranchPoint after{.value = value, .motion = {}};
  PointResult result = compute(step, swept, from, after.motion, context);
  if (searches_jumps()) {
    const Jump jump = before ? search(*before, after, swept, context) : Jump{};
    if (jump.start_on_branch) {
      swept.move_to(value);
      result = compute(step, swept, *jump.start_on_branch, after.motion, context);
    }
    add_jump(result, jump, after.motion, settings_.parameter.unit);
  }
  from = after.motion.state;
  before = std::move(after);
  return result;
}

void SteppedSweep::run_line(std::size_t line, System &system, LineContext &context) const {
  SweptSystem swept(settings_.parameter, settings_.excitation, settings_.recorders, system,
                    context);
  MotionState from;                  // empty until a first point has started
  std::optional<BranchPoint> before; // the last point of this direction that succeeded
  std::size_t direction = 0;
  for (const Step &step : steps_of_line(line)) {
    if (step.direction != direction)
      before.reset();
    direction = step.direction;
    if (const PointResult *known = context.find(step.index())) {
      if (known->status == Status::finished) {
        before = {.value = settings_.parameter.values[step.point], .motion = stored_motion(*known)};
        from = before->motion.state;
      }
      context.skip();
      continue;
    }
    // After a failure the next point goes on from where this one started.
    try {
      context.store(advance(step, swept, from, before, context));
    } catch (const NumericalError &error) {
      context.store({.index = step.index(), .status = Status::failed, .reason = error.what()});
    } catch (const InputError &error) {
      context.store({.index = step.index(), .status = Status::failed, .reason = error.what()});
    }
  }
}

} // namespace vibroimpact::analyses
