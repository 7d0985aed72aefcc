// Records a window of a motion and finds the figures by name, for tests.
#pragma once

#include "analyses/recorders/window_recording.h"
#include "support/lumped_models.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace vibroimpact::testing {

/// A system of one model that starts from rest.
inline analyses::System system_of(model::Model model, contact::ContactSet contacts = {}) {
  const Index n = model.size();
  return {.model = std::move(model),
          .contacts = std::move(contacts),
          .integration = {.relative_tolerance = 1e-10},
          .initial = {.displacement = Vector::Zero(n), .velocity = Vector::Zero(n)}};
}

/// A block on a base shaken at 8 rad/s, with a connection to that base.
inline model::Model linked_block() {
  model::Model model({single_mass("block", 1, 100, 1)});
  model.add_base_motion("floor",
                        std::make_shared<model::Harmonic>(model::Given::displacement, 0.01, 8, 0),
                        {0}, Vector3::UnitX());
  model.add_connection({.name = "link",
                        .side_a = "block.head",
                        .side_b = "base",
                        .elongation = model.displacement({}, -Vector3::UnitX(), false),
                        .damping = 0.5});
  return model;
}

inline bool has_field(const PointResult &result, const std::string &name) {
  for (const Field &field : result.fields)
    if (field.name() == name)
      return true;
  return false;
}

inline const Field &field_of(const PointResult &result, const std::string &name) {
  for (const Field &field : result.fields)
    if (field.name() == name)
      return field;
  throw std::logic_error("no field " + name);
}

inline double value_of(const PointResult &result, const std::string &name) {
  return field_of(result, name).values.at(0);
}

/// What one recorder sees in a window from the initial state.
template <class Kind, class... Options>
PointResult recorded(const analyses::System &system, const analyses::Window &window,
                     const Options &...options) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(window.start, system.initial.displacement, system.initial.velocity);
  analyses::WindowRecording recording(
      {[&](const analyses::System &s) { return std::make_unique<Kind>(options..., s); }}, system);
  recording.run(window, trajectory);
  PointResult result;
  recording.add_fields(result);
  return result;
}

} // namespace vibroimpact::testing
