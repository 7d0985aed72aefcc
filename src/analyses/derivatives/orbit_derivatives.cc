#include "analyses/derivatives/orbit_derivatives.h"

#include "analyses/derivatives/tangent_motion.h"
#include "analyses/keys/keyed_system.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/results/fields.h"
#include "common/decompositions.h"
#include "common/error.h"
#include "motion/variation/key_stencil.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using motion::KeyNeighbour;

namespace {

constexpr double nearly_singular = 1e-10; // of 1 - P_x, relative to 1

/// The whole motion, which a key that takes the symmetry away leaves periodic.
periodic::Section whole(const periodic::Orbit &orbit) {
  return {.phase = orbit.section.phase, .halves = 2 * orbit.multiple()};
}

/// Of a state at a phase and, where it is free, of the period [s].
struct ByKey {
  Vector state;
  double period = 0;
};

// Of the way to the plane, by what the motion is off it after the fixed time.
double period_by_key(const RecordedOrbit &motion, const Vector &by_key) {
  const periodic::Section section = whole(motion.orbit);
  const periodic::Flow flow = motion.map.flow(0, section.length(), motion.orbit.point.state);
  const Vector &normal = motion.map.plane(section, motion.orbit.point.state).normal;
  return -normal.dot(flow.by_state * by_key + flow.by_keys.col(0)) /
         (normal.dot(flow.rates) * section.length());
}

/// At the section, keeping the phase of the forcing.
Vector state_by_key(const RecordedOrbit &motion) {
  const periodic::Flow flow = motion.map.image(whole(motion.orbit), motion.orbit.point.state);
  const Vector scale = motion.map.scale();
  const Matrix rest = Matrix::Identity(scale.size(), scale.size()) -
                      scale.asDiagonal() * flow.by_state * scale.cwiseInverse().asDiagonal();
  const auto by_key =
      solve_well_conditioned(rest, scale.cwiseProduct(flow.by_keys.col(0)), nearly_singular);
  if (!by_key)
    throw NumericalError("the motion stands at a fold or at the end of its stability, where it has "
                         "no derivative by a key");
  return scale.cwiseInverse().cwiseProduct(*by_key);
}

/// At the forcing phase of time zero.
Vector at_zero_phase(const RecordedOrbit &motion, const ByKey &by_key) {
  const double phase = motion.orbit.section.phase;
  if (phase == 0)
    return by_key.state;
  const auto end = static_cast<double>(motion.orbit.multiple());
  const periodic::Flow flow = motion.map.flow(phase, end, motion.orbit.point.state);
  return flow.by_state * by_key.state + flow.by_keys.col(0) +
         flow.rates * ((end - phase) * by_key.period);
}

struct Recorded {
  PointResult point{};
  long events = 0;
};

Recorded record(const System &system, const Vector &state, const RecordedOrbit &motion,
                double period) {
  periodic::ForcedSystem forced = forced_like(system, motion, period);
  const double start = motion.orbit.section.phase * forced.period();
  WindowRecording recording(motion.recorders, system);
  forced.trajectory().start({.time = start, .physical = state});
  recording.run(periods_window(start, forced.period(), motion.orbit.multiple()),
                forced.trajectory());
  Recorded recorded{.events = forced.trajectory().accuracy().events};
  recording.add_fields(recorded.point);
  return recorded;
}

std::vector<Recorded> record_neighbours(const std::vector<KeyNeighbour> &neighbours,
                                        const ByKey &by_key, const RecordedOrbit &motion) {
  std::vector<Recorded> all;
  for (const KeyNeighbour &near : neighbours) {
    const System system{.model = near.own_model(),
                        .contacts = *near.contacts,
                        .integration = motion.system.integration,
                        .initial = motion.system.initial};
    all.push_back(record(system, motion.orbit.point.state + near.offset * by_key.state, motion,
                         motion.map.period() + near.offset * by_key.period));
  }
  return all;
}

std::string unit_by_key(const std::string &unit, const std::string &key_unit) {
  return key_unit == "1" ? unit : unit + "/(" + key_unit + ")";
}

double difference(const Field &field, const std::vector<Recorded> &near, const Vector &weight) {
  double derivative = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const double there = field_of(near[i].point, field.name()).values[0];
    derivative += weight[static_cast<Index>(i)] * (there - field.values[0]);
  }
  return derivative;
}

void add_recorded(const FieldWriter &result, const OrbitKey &key, const Recorded &present,
                  const PointResult &tangents, const std::vector<Recorded> &near,
                  const Vector &weight) {
  for (const Field &field : present.point.fields) {
    if (!field.shape.empty() || field.unit() == "1" || !std::isfinite(field.values[0]))
      continue;
    const Field *known = find(tangents, field.name());
    result.number(
        field.name(), known != nullptr ? known->values[0] : difference(field, near, weight),
        unit_by_key(field.unit(), key.parameter.unit), "derivative: " + field.description());
  }
}

} // namespace

periodic::ForcedSystem forced_like(const System &system, const RecordedOrbit &motion,
                                   double period) {
  if (const auto source = motion.map.system().source())
    return {system.model, system.contacts, system.integration, *source};
  return {system.model, system.contacts, system.integration,
          std::make_shared<periodic::FreePeriod>(period)};
}

void declare_orbit_keys(parameters::Section &section) {
  section
      .named_subsection("Derivative", "A key by which the motion and what is recorded of it are "
                                      "differentiated.")
      .text("Path", "",
            "The key, as for --set: Contact/stop/Clearance, or Variables/lambda; empty means the "
            "frequency of the excitation.");
}

std::vector<OrbitKey> read_orbit_keys(const parameters::Values &section) {
  std::vector<OrbitKey> keys;
  for (const std::string &name : section.instances("Derivative")) {
    const parameters::Values one = section.instance("Derivative", name);
    keys.push_back({.name = name, .parameter = {}});
    const std::string path = one.text("Path");
    if (path.empty())
      continue;
    const std::string target = one.key_path("Path");
    if (target.starts_with("Analysis ") || target.starts_with("Derived "))
      one.reject("Path", "must be a key outside the analyses");
    const auto number = section.parameters().number_at(path);
    if (!number)
      one.reject("Path", "must be a key with one number as its value");
    keys.back().parameter = {.path = path,
                             .unit = number->unit,
                             .values = {number->value},
                             .origin = one.place("Path") + ":"};
  }
  return keys;
}

void add_derivatives(const FieldWriter &result, const OrbitKey &key, const RecordedOrbit &motion,
                     const SystemSource &build) {
  const std::shared_ptr<const System> present_system(std::shared_ptr<const System>(),
                                                     &motion.system);
  const std::vector<KeyNeighbour> neighbours =
      key.parameter.is_frequency()
          ? frequency_neighbours(present_system, *motion.map.system().source())
          : key_neighbours(key.parameter, key.parameter.values[0], build);
  periodic::ForcedKey forced = forced_key(key.name, motion.map.system(), neighbours);
  motion.map.set_keys({&forced});
  ByKey by_key{.state = state_by_key(motion)};
  const bool free = motion.map.system().free_period() != nullptr;
  if (free)
    by_key.period = period_by_key(motion, by_key.state);
  const FieldWriter of = result.below("derivative/" + key.name + "/"), listed = of.listed();
  of.array({"state",
            "SI",
            "derivative of the state at the forcing phase of time zero, by the key in " +
                key.parameter.unit,
            {state_dimension}},
           at_zero_phase(motion, by_key));
  motion.map.set_keys({});
  const PointResult tangents = measure_tangents(motion, forced, neighbours, by_key.state);
  std::vector<double> offsets;
  for (const KeyNeighbour &neighbour : neighbours)
    offsets.push_back(neighbour.offset);
  const Vector weight = motion::derivative_weights(offsets);
  const Recorded present =
      record(motion.system, motion.orbit.point.state, motion, motion.map.period());
  const std::vector<Recorded> near = record_neighbours(neighbours, by_key, motion);
  const bool smooth = std::all_of(
      near.begin(), near.end(), [&](const Recorded &one) { return one.events == present.events; });
  listed.number("smooth", smooth ? 1 : 0, "1",
                "0 where motions with the key some thousandths off have another number of contact "
                "changes, so that derivatives of what other recorders give may be of no use");
  if (!key.parameter.is_frequency())
    listed.number("value", key.parameter.values[0], key.parameter.unit,
                  "value of the key " + key.parameter.path);
  if (free)
    listed.number("period", by_key.period * static_cast<double>(motion.orbit.multiple()),
                  unit_by_key("s", key.parameter.unit), "derivative of the period");
  add_recorded(listed, key, present, tangents, near, weight);
}

} // namespace vibroimpact::analyses
