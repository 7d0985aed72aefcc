// Systems whose nonlinear modes are known, and runs of them.
#pragma once

#include "analyses/curves/nonlinear_mode.h"
#include "support/recorded_windows.h"
#include "support/rigid_contacts.h"
#include "support/steps_in_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses::known_modes {

using testing::field_of;

constexpr double pi = std::numbers::pi;

class ModePoint : public LineContext {
public:
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(PointResult stored) override { result = std::move(stored); }
  void skip() override {}
  std::unique_ptr<StepRecord> steps(const std::vector<std::size_t> & /*index*/) override {
    return std::make_unique<testing::HandedSteps>(known, fresh);
  }
  PointResult result;
  std::vector<std::string> known, fresh;
};

inline NonlinearMode::Settings between(double first, double last, long mode = 1) {
  NonlinearMode::Settings settings{.start = {.mode = mode, .energy = first, .last_energy = last},
                                   .recorders = {}};
  settings.continuation.first_key = {.lower = first, .upper = last};
  return settings;
}

inline PointResult mode_of(System system, const NonlinearMode::Settings &settings) {
  ModePoint point;
  const NonlinearMode mode(settings);
  mode.check(system);
  mode.run_line(0, system, point);
  EXPECT_EQ(point.result.status, Status::finished) << point.result.reason;
  return point.result;
}

/// A unit mass on a unit spring.
inline System oscillator(double damping = 0) {
  return testing::system_of(model::Model({testing::single_mass("block", 1, 1, damping)}));
}

inline System oscillator_on_stop(double clearance, std::shared_ptr<const contact::ContactLaw> law,
                                 double damping = 0) {
  System system = oscillator(damping);
  system.contacts = contact::ContactSet(
      {testing::contact_along_x(system.model, "block.head", "", clearance, std::move(law))});
  return system;
}

/// Two unit masses in a row, K = [[2, -1], [-1, 1]].
inline System two_masses(double damping = 0) {
  System system = testing::system_of(
      model::Model({testing::single_mass("a", 1, 1, damping), testing::single_mass("b", 1, 0, 0)}));
  model::PointReference a{.body = 0}, b{.body = 1};
  model::Projection elongation = system.model.displacement(b, Vector3::UnitX(), false);
  elongation.row -= system.model.displacement(a, Vector3::UnitX(), false).row;
  system.model.add_connection({.name = "link",
                               .side_a = "a.head",
                               .side_b = "b.head",
                               .elongation = elongation,
                               .stiffness = 1,
                               .damping = damping});
  return system;
}

/// Frequencies [rad/s] with the energies of all points.
struct Backbone {
  std::vector<double> energy, omega;
  explicit Backbone(const PointResult &result)
      : energy(field_of(result, "energy").values), omega(field_of(result, "frequency").values) {
    for (double &frequency : omega)
      frequency *= 2 * pi;
  }
};

inline System with_cubic_spring(System system, double cubic) {
  system.model.add_connection({.name = "spring",
                               .side_a = "block.head",
                               .side_b = "ground",
                               .elongation = system.model.displacement({}, Vector3::UnitX(), false),
                               .cubic_stiffness = cubic});
  return system;
}

inline double backbone_of_cubic_spring(double cubic, double square_of_amplitude) {
  const double rise = 1 + cubic * square_of_amplitude;
  const double m = cubic * square_of_amplitude / (2 * rise);
  return pi * std::sqrt(rise) / (2 * std::comp_ellint_1(std::sqrt(m)));
}

} // namespace vibroimpact::analyses::known_modes
