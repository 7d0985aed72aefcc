#include "analyses/curves/periodic_orbit.h"

#include "analyses/curves/orbit_fields.h"
#include "analyses/keys/keyed_system.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/results/fields.h"
#include "common/error.h"

namespace vibroimpact::analyses {

namespace {
constexpr const char *periodic_orbit_section = "Periodic orbit";
} // namespace

void PeriodicOrbit::declare(parameters::Section &analysis) {
  parameters::Section &section = analysis.subsection(
      periodic_orbit_section,
      "A motion that repeats itself, stable or not: where a settled motion or a given "
      "state leads by Newton's method, with its multipliers.");
  declare_orbit_start(section);
  declare_orbit_keys(section);
  section.text("Excitation", "",
               "Excitation whose period is that of the forcing; empty when there is only one with "
               "a period.");
}

std::shared_ptr<const Analysis> PeriodicOrbit::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(periodic_orbit_section);
  return std::make_shared<PeriodicOrbit>(
      Settings{.start = read_orbit_start(values),
               .excitation = values.text("Excitation"),
               .recorders = read_recorders(analysis, {"extreme values", "impacts"}),
               .keys = read_orbit_keys(values)});
}

void PeriodicOrbit::check(const System &system) const {
  OrbitSearch search(system, period_source(system, settings_.excitation, "A periodic orbit"),
                     settings_.start);
  for (const OrbitKey &key : settings_.keys)
    if (search.free_period() && key.parameter.is_frequency())
      throw InputError("Derivative " + key.name +
                       " needs a Path: nothing changes with time here, so that there is no "
                       "frequency of an excitation.");
  search.forced().trajectory().start(0, system.initial.displacement, system.initial.velocity);
  const WindowRecording recording(settings_.recorders, system);
}

void PeriodicOrbit::check_built(const SystemSource &build) const {
  for (const OrbitKey &key : settings_.keys)
    if (!key.parameter.is_frequency())
      key_neighbours(key.parameter, key.parameter.values[0], build);
}

void PeriodicOrbit::add_all_derivatives(PointResult &result, const RecordedOrbit &motion,
                                        const LineContext &context) const {
  for (const OrbitKey &key : settings_.keys)
    try {
      add_derivatives(result, key, motion,
                      [&context](const auto &overrides) { return context.build(overrides); });
    } catch (const NumericalError &error) {
      result.reason += "no derivative by " + key.name + ": " + error.what() + ". ";
    }
}

PointResult PeriodicOrbit::compute(const System &system, LineContext &context) const {
  OrbitSearch search(system, period_source(system, settings_.excitation, "A periodic orbit"),
                     settings_.start);
  const periodic::Orbit orbit = search.run([&](long periods) {
    context.note_progress(static_cast<double>(periods) /
                          static_cast<double>(settings_.start.settling.maximum + 10));
  });
  PointResult result;
  const Vector state = state_at_zero_phase(search.map(), orbit);
  const periodic::Orbit recorded =
      record_orbit(result, settings_.recorders, system, search.map(), orbit, state);
  add_orbit(result, search.map(), orbit, state);
  FieldWriter(result).number("settling_cycles", static_cast<double>(search.settling_cycles()), "1",
                             "forcing periods before Newton's method");
  add_settled_multiple(result, search.settled_multiple());
  add_accuracy(result, search.forced().trajectory().accuracy(), system.integration);
  add_all_derivatives(
      result,
      {.system = system, .map = search.map(), .orbit = recorded, .recorders = settings_.recorders},
      context);
  return result;
}

void PeriodicOrbit::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_orbit_point(system, context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
