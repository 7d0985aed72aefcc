#include "analyses/isolators/isolator_system.h"

#include "analyses/keys/keyed_system.h"
#include "common/error.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

[[noreturn]] void refuse_isolator(const std::string &needed) {
  throw InputError("An isolator design must have " + needed);
}

void check_model(const model::Model &model) {
  if (model.size() != 1)
    refuse_isolator("a model with one coordinate, but this one has " +
                    std::to_string(model.size()) + ".");
  if (!model.linear())
    refuse_isolator("an isolator without cubic springs and rotors.");
  if (!(model.stiffness().diagonal[0] > 0))
    refuse_isolator("an isolator with a spring: its stiffness must be greater than 0 N/m.");
  if (model.sources().size() != 1)
    refuse_isolator("one excitation, a harmonic force, but this model has " +
                    std::to_string(model.sources().size()) + ".");
}

/// Amplitude of the load on the coordinate.
double load_amplitude(const model::Source &source) {
  const model::TimeFunction &history = *source.function;
  if (!history.harmonic() || source.inertial_load.any() || source.rate_load.any())
    refuse_isolator("a harmonic force; the excitation " + source.name + " is none.");
  const double frequency = 2 * std::numbers::pi / history.period();
  const double amplitude = std::hypot(history.value(0), history.rate(0) / frequency);
  if (!(std::abs(source.load[0]) * amplitude > 0))
    refuse_isolator("a force whose amplitude along the motion is greater than 0 N.");
  return std::abs(source.load[0]) * amplitude;
}

bool is_stop(const contact::ContactPair &pair) {
  return pair.side_b == "stop" && !pair.circle && pair.law->name() == "bilinear stop";
}

bool nearly_equal(double one, double other) {
  return std::abs(one - other) <= 1e-9 * std::abs(one);
}

void check_stops(const contact::ContactSet &contacts) {
  if (contacts.size() != 2 || !is_stop(contacts.pairs()[0]) || !is_stop(contacts.pairs()[1]))
    refuse_isolator("two contacts with stops, of the law bilinear stop.");
  const contact::ContactPair &one = contacts.pairs()[0], &other = contacts.pairs()[1];
  if (!nearly_equal(one.gap.row[0], -other.gap.row[0]))
    refuse_isolator("its two stops on opposite sides; " + one.name + " and " + other.name +
                    " are not.");
  const contact::AffineForm &law = one.law->modes()[1].affine->force;
  const contact::AffineForm &of_other = other.law->modes()[1].affine->force;
  if (!nearly_equal(one.clearance, other.clearance) || !nearly_equal(law.gap, of_other.gap) ||
      !nearly_equal(law.gap_rate, of_other.gap_rate))
    refuse_isolator("two equal stops; clearance, stiffness or damping of " + one.name + " and " +
                    other.name + " differ.");
  if (!(one.clearance > 0))
    refuse_isolator("stops with a clearance greater than 0 m.");
}

} // namespace

double IsolatorSystem::natural_frequency() const { return std::sqrt(stiffness / mass); }

IsolatorDamping IsolatorSystem::damping_ratios() const {
  const double critical = 2 * std::sqrt(mass * stiffness);
  return {.isolator = damping / critical, .stop = stop_damping / critical};
}

StopChoice IsolatorSystem::stop() const {
  return {.stiffness = stop_stiffness / stiffness, .force = force / (stiffness * clearance)};
}

double IsolatorSystem::clearance_of(const StopChoice &choice) const {
  return force / (stiffness * choice.force);
}

IsolatorSystem read_isolator(const System &system, const std::string &excitation) {
  check_model(system.model);
  const std::size_t source = sweep_source(system, excitation, "An isolator design");
  check_stops(system.contacts);
  const contact::ContactPair &stop = system.contacts.pairs()[0];
  const contact::AffineForm &law = stop.law->modes()[1].affine->force;
  const double row = std::abs(stop.gap.row[0]); // displacement along the normal per coordinate
  Index axis = 0;
  stop.normal.cwiseAbs().maxCoeff(&axis);
  IsolatorSystem isolator{.mass = system.model.mass()[0] / (row * row),
                          .stiffness = system.model.stiffness().diagonal[0] / (row * row),
                          .damping = system.model.damping().diagonal[0] / (row * row),
                          .stop_stiffness = -law.gap,
                          .stop_damping = -law.gap_rate,
                          .clearance = stop.clearance,
                          .force = load_amplitude(system.model.sources()[source]) / row,
                          .point = stop.side_a,
                          .axis = "xyz"[axis]};
  if (!(isolator.stop_damping > 0))
    refuse_isolator("stops with damping: Damping constant must be greater than 0 N s/m.");
  if (!(isolator.damping_ratios().sigma() < largest_damping_ratio))
    refuse_isolator("stops with more damping: that of the isolator must be below " +
                    std::to_string(largest_damping_ratio) + " of that of a stop, but is " +
                    std::to_string(isolator.damping_ratios().sigma()) + ".");
  return isolator;
}

} // namespace vibroimpact::analyses
