#include "analyses/sweeps/steady_state.h"

#include "analyses/recorders/motion_progress.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/results/fields.h"
#include "analyses/run/single_point.h"
#include "analyses/sweeps/steadiness.h"
#include "common/error.h"

#include <numbers>

namespace vibroimpact::analyses {

using motion::Trajectory;

namespace {

constexpr const char *steady_state_section = "Steady state";

void refuse_both(const parameters::Values &values, const char *time, const char *cycles) {
  if (values.has(time) && values.given(cycles))
    values.reject(time, std::string("must not be set when ") + cycles + " is set");
}

} // namespace

void SteadyState::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      steady_state_section, "One motion from the initial conditions: settles, then is recorded.");
  declare_settling(section);
  section
      .quantity("Settling time", "", dimension::time, range::non_negative, "",
                "Settles for this time, steady or not, instead of Settling cycles.")
      .integer("Recorded cycles", "10", Range{.lower = 1, .upper = 1e9}, "",
               "Periods of the recorded window.")
      .quantity("Recorded time", "", dimension::time, range::positive, "",
                "Length of the recorded window instead of Recorded cycles.")
      .text("Excitation", "",
            "Excitation whose period counts cycles; empty when there is only one with a period.");
}

std::shared_ptr<const Analysis> SteadyState::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(steady_state_section);
  refuse_both(values, "Settling time", "Settling cycles");
  refuse_both(values, "Settling time", "Minimum settling cycles");
  refuse_both(values, "Recorded time", "Recorded cycles");
  const bool by_time = values.has("Settling time");
  return std::make_shared<SteadyState>(
      Settings{.settling = read_settling(values),
               .settling_time = by_time ? values.quantity("Settling time") : 0,
               .by_time = by_time,
               .cycles = values.integer("Recorded cycles"),
               .recorded_time = values.has("Recorded time") ? values.quantity("Recorded time") : 0,
               .excitation = values.text("Excitation"),
               .recorders = read_recorders(analysis, {"extreme values", "impacts"})});
}

// Of the excitation that counts the cycles; 0 when none is needed.
double SteadyState::period(const System &system) const {
  if (!settings_.needs_period())
    return 0;
  std::vector<double> periods;
  for (const model::Source &source : system.model.sources())
    if (source.function->period() > 0 &&
        (settings_.excitation.empty() || source.name == settings_.excitation))
      periods.push_back(source.function->period());
  if (periods.size() == 1)
    return periods[0];
  if (!settings_.excitation.empty())
    throw InputError("Excitation must name an active excitation with a period, which " +
                     settings_.excitation + " is not.");
  throw InputError("Excitation must be set when not exactly one excitation has a period; when none "
                   "has one, Settling time and Recorded time must be set.");
}

void SteadyState::check(const System &system) const {
  period(system);
  Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  const WindowRecording recording(settings_.recorders, system);
}

// The motion that is not recorded is the whole but for the window: `share` of the work at most.
SettledMotion SteadyState::settle_motion(const System &system, Trajectory &trajectory,
                                         double period, double share, LineContext &context) const {
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  if (!settings_.by_time)
    return Settler(trajectory)(
        period, state_scale(trajectory.equations(), 2 * std::numbers::pi / period),
        settings_.settling, [&](long periods) {
          context.note_progress(share * static_cast<double>(periods) /
                                static_cast<double>(settings_.settling.maximum));
        });
  constexpr int parts = 100; // after each of which the progress is noted
  for (int i = 1; settings_.settling_time > 0 && i <= parts; ++i) {
    trajectory.advance(i == parts ? settings_.settling_time : settings_.settling_time * i / parts);
    context.note_progress(share * i / parts);
  }
  return {};
}

double SteadyState::settling_share(double period) const {
  const double settling = settings_.by_time
                              ? settings_.settling_time
                              : static_cast<double>(settings_.settling.maximum) * period;
  return settling / (settling + window(0, period).end);
}

Window SteadyState::window(double start, double period) const {
  return settings_.recorded_time > 0
             ? Window{.start = start, .end = start + settings_.recorded_time}
             : periods_window(start, period, settings_.cycles);
}

PointResult SteadyState::compute(const System &system, LineContext &context) const {
  const double cycle = period(system);
  const double share = settling_share(cycle);
  Trajectory trajectory(system.model, system.contacts, system.integration);
  WindowRecording recording(settings_.recorders, system);
  const SettledMotion settled = settle_motion(system, trajectory, cycle, share, context);
  const Window recorded = window(trajectory.time(), cycle);
  MotionProgress progress(context, recorded.start, recorded.end, share);
  recording.run(recorded, trajectory, {&progress});

  PointResult result;
  recording.add_fields(result);
  if (!settings_.by_time)
    add_settled(result, settled.steady(), settled.multiple, settled.cycles);
  const Vector state = trajectory.motion_state().physical;
  FieldWriter(result).series("state", state_dimension, {state.begin(), state.end()}, "SI",
                             "state at the end: coordinates, their rates, internal "
                             "states of contacts, torques of motors");
  add_accuracy(result, trajectory.accuracy(), system.integration);
  return result;
}

void SteadyState::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
