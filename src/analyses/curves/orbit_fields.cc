#include "analyses/curves/orbit_fields.h"

#include "analyses/recorders/window_recording.h"
#include "analyses/results/fields.h"
#include "common/scalar.h"

namespace vibroimpact::analyses {

namespace {

struct OrbitLabels {
  Label real{"multiplier_real",
             "1",
             "real part of the multipliers of the periodic motion: eigenvalues of the "
             "map of small perturbations over a period, the largest first",
             {"multiplier"}};
  Label imaginary{"multiplier_imaginary", "1", "imaginary part of the multipliers", {"multiplier"}};
  Label stable{"stable", "1", "1 when all multipliers are smaller than 1 in absolute value"};
  Label residual{"orbit_residual", "1",
                 "largest entry of the state after the period less that before it, over the "
                 "largest entry of the state, both made comparable"};
  Label multiple{"period_multiple", "1", "forcing periods after which the motion repeats itself"};
  Label symmetric{"symmetric", "1",
                  "1 when the motion of half its period is the mirror image of the other half"};
  Label phase{"section_phase", "1",
              "phase of the forcing, as a share of its period, at which the motion was cut, away "
              "from contact changes"};
  Label period{"period", "s", "time after which the motion repeats itself"};
  Label iterations{"newton_iterations", "1", "iterations of Newton's method for the motion"};
  Label without{
      "events_without_derivative", "1",
      "contact changes of the motion that have no derivative, such as grazing contacts; where "
      "there are any, the multipliers are of no use"};
  Label settled{"settled_multiple", "1",
                "forcing periods after which the settled motion repeated itself that Newton's "
                "method began with; 0 where it was not seen to repeat itself within Longest "
                "period, NaN where nothing was to settle"};
  Label state{"state",
              "SI",
              "state at the forcing phase of time zero: coordinates, their rates, internal states "
              "of contacts",
              {state_dimension}};
};

const OrbitLabels &orbit_labels() {
  static const OrbitLabels labels;
  return labels;
}

bool any_closed(const contact::ContactSet &contacts, const std::vector<int> &modes) {
  for (std::size_t c = 0; c < modes.size(); ++c)
    if (contacts.pairs()[c].law->modes()[static_cast<std::size_t>(modes[c])].in_contact)
      return true;
  return false;
}

/// Where the motion is recorded from [periods].
double open_phase(const contact::ContactSet &contacts, const periodic::StroboscopicMap &map,
                  const periodic::Orbit &orbit, const Vector &state_at_zero) {
  if (!any_closed(contacts, map.start(0, state_at_zero).equations().modes()))
    return 0;
  const auto periods = static_cast<double>(orbit.multiple());
  periodic::PatternObserver seen(contacts, 0);
  map.observe(0, periods, state_at_zero, seen);
  const double open = seen.pattern(periods * map.period()).open_instant() / map.period();
  return open > 0 ? open : orbit.section.phase;
}

} // namespace

void add_orbit(const FieldWriter &result, const periodic::StroboscopicMap &map,
               const periodic::Orbit &orbit, const Vector &state_at_zero, double margin) {
  const OrbitLabels &labels = orbit_labels();
  const FieldWriter listed = result.listed();
  const Eigen::VectorXcd multipliers = orbit.multipliers(map);
  result.array(labels.real, multipliers.real());
  result.array(labels.imaginary, multipliers.imag());
  if (multipliers.size() > 0) {
    result.line("multiplier[1].real", multipliers[0].real(), "1");
    result.line("multiplier[1].imaginary", multipliers[0].imag(), "1");
  }
  listed.number(labels.stable, periodic::is_stable(multipliers / (1 + margin)) ? 1 : 0);
  listed.number(labels.residual, orbit.point.residual);
  listed.number(labels.multiple, static_cast<double>(orbit.multiple()));
  listed.number(labels.symmetric, orbit.symmetric() ? 1 : 0);
  listed.number(labels.phase, orbit.section.phase);
  if (map.system().free_period())
    listed.number(labels.period, static_cast<double>(orbit.multiple()) * map.period());
  listed.number(labels.iterations, static_cast<double>(orbit.iterations));
  listed.number(labels.without, static_cast<double>(orbit.point.image.without_derivative));
  result.array(labels.state, state_at_zero);
}

periodic::Orbit record_orbit(const FieldWriter &result,
                             const std::vector<RecorderFactory> &recorders, const System &system,
                             const periodic::StroboscopicMap &map, const periodic::Orbit &orbit,
                             const Vector &state_at_zero) {
  periodic::Orbit recorded = orbit;
  recorded.section.phase = open_phase(system.contacts, map, orbit, state_at_zero);
  recorded.point.state = recorded.section.phase == 0
                             ? state_at_zero
                             : map.carry(0, recorded.section.phase, state_at_zero);
  WindowRecording recording(recorders, system);
  const double start = recorded.section.phase * map.period();
  motion::Trajectory &trajectory = map.start(recorded.section.phase, recorded.point.state);
  recording.run(periods_window(start, map.period(), orbit.multiple()), trajectory);
  recording.add_fields(result);
  return recorded.section.phase == 0 ? orbit : recorded;
}

void add_settled_multiple(PointResult &result, std::optional<long> multiple) {
  FieldWriter(result).number(orbit_labels().settled,
                             multiple ? static_cast<double>(*multiple) : nan);
  if (settled_elsewhere(result))
    result.reason += "the motion that had settled is another one than this unstable orbit: it "
                     "repeats itself after more forcing periods than Longest period, or not at "
                     "all. ";
}

bool settled_elsewhere(const PointResult &result) {
  const auto is_zero = [&](const Label &label) { return number_of(result, label.name(), 1) == 0; };
  return is_zero(orbit_labels().settled) && is_zero(orbit_labels().stable);
}

} // namespace vibroimpact::analyses
