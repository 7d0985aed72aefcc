// Derivatives of periodic motions by keys: against closed forms, against differences of motions
// that are found anew, and against the variational equations up to the instant of an extreme value.
#include "analyses/derivatives/orbit_derivatives.h"
#include "analyses/curves/periodic_orbit.h"
#include "analyses/keys/keyed_system.h"

#include "common/error.h"
#include "contact/laws/bilinear_stop.h"
#include "support/points.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace orbit_derivatives_tests {

using testing::field_of;
using testing::value_of;

struct Isolator {
  double stiffness = 1, damping = 0.02, amplitude = 0.52, clearance = 1, stop = 2, lambda = 1.3;
};

System isolator(const Isolator &of) {
  model::Model model({testing::single_mass("block", 1, of.stiffness, of.damping)});
  model.add_force(
      "push",
      std::make_shared<model::Harmonic>(model::Given::displacement, of.amplitude, of.lambda, 0), {},
      Vector3::UnitX());
  const auto law = std::make_shared<contact::BilinearStop>(of.stop, 0.4);
  contact::ContactPair right = testing::contact_along_x(model, "block.head", "", of.clearance, law);
  contact::ContactPair left = right;
  right.name = "right";
  left.name = "left";
  left.gap.row *= -1;
  return testing::system_of(std::move(model), contact::ContactSet({right, left}));
}

/// Keys by their names as paths.
Isolator changed(Isolator of, const std::string &path, double value) {
  (path == "stiffness"   ? of.stiffness
   : path == "damping"   ? of.damping
   : path == "amplitude" ? of.amplitude
   : path == "clearance" ? of.clearance
   : path == "stop"      ? of.stop
                         : of.lambda) = value;
  return of;
}

double present(const Isolator &of, const std::string &path) {
  return path == "stiffness"   ? of.stiffness
         : path == "damping"   ? of.damping
         : path == "amplitude" ? of.amplitude
         : path == "clearance" ? of.clearance
                               : of.stop;
}

PointResult orbit(const Isolator &of, const std::vector<double> &state,
                  const std::vector<std::string> &paths) {
  std::vector<OrbitKey> keys;
  for (const std::string &path : paths)
    keys.push_back(
        {path, path == "frequency"
                   ? SweptParameter{}
                   : SweptParameter{.path = path, .unit = "1", .values = {present(of, path)}}});
  testing::Points points([&](const std::vector<parameters::Override> &overrides) {
    return isolator(changed(of, overrides[0].path, std::stod(overrides[0].value)));
  });
  System system = isolator(of);
  PeriodicOrbit({.start = {.state = state}, .excitation = {}, .keys = keys})
      .run_line(0, system, points);
  return points.all().at({});
}

const std::vector<double> small{0.72, 0.2}, unstable{-0.41, -1.68}, large{-1.0, 2.3};
const std::vector<std::string> keys{"stiffness", "damping", "amplitude", "clearance", "stop"};
const std::vector<std::string> measured{
    "point/block.head/displacement_x/largest", "point/block.head/velocity_x/maximum",
    "contact/right/peak_force/maximum", "contact/right/impulse/mean"};

double richardson(const Isolator &of, const std::vector<double> &state, const std::string &path,
                  const std::string &field, double step) {
  const auto difference = [&](double h) {
    const auto at = [&](double value) {
      const PointResult found = orbit(changed(of, path, value), state, {});
      EXPECT_EQ(found.status, Status::finished) << found.reason;
      return value_of(found, field);
    };
    const double value = path == "lambda" ? of.lambda : present(of, path);
    return (at(value + h) - at(value - h)) / (2 * h);
  };
  return (4 * difference(step / 2) - difference(step)) / 3;
}

// Without contact |X| = F / |k - w^2 + i c w|.
TEST(OrbitDerivativesTest, OfALinearResponse) {
  const Isolator of{.lambda = 1.5};
  const PointResult found = orbit(of, {0, 0}, {"stiffness", "damping", "amplitude", "frequency"});
  ASSERT_EQ(found.status, Status::finished) << found.reason;
  const double w = of.lambda, d = of.stiffness - w * w;
  const double size = std::hypot(d, of.damping * w), x = of.amplitude / size;
  ASSERT_LT(x, 1); // no contact
  const auto near = [&](const std::string &key, double expected) {
    EXPECT_NEAR(value_of(found, "derivative/" + key + "/" + measured[0]), expected,
                1e-8 * std::abs(expected))
        << key;
  };
  near("stiffness", -x * d / (size * size));
  near("damping", -x * of.damping * w * w / (size * size));
  near("amplitude", x / of.amplitude);
  near("frequency",
       2 * std::numbers::pi * -x * (-2 * w * d + of.damping * of.damping * w) / (size * size));
  EXPECT_EQ(value_of(found, "derivative/stiffness/smooth"), 1);
}

class OrbitDerivativesOf : public ::testing::TestWithParam<std::vector<double>> {};

TEST_P(OrbitDerivativesOf, AMotionWithContactAgreeWithDifferences) {
  const Isolator of;
  const PointResult found = orbit(of, GetParam(), keys);
  ASSERT_EQ(found.status, Status::finished) << found.reason;
  for (const std::string &key : keys) {
    EXPECT_EQ(value_of(found, "derivative/" + key + "/smooth"), 1);
    for (const std::string &field : measured) {
      const double exact = richardson(of, field_of(found, "state").values, key, field, 1e-3);
      EXPECT_NEAR(value_of(found, "derivative/" + key + "/" + field), exact,
                  1e-6 * std::max(1.0, std::abs(exact)))
          << key << " " << field;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OrbitDerivatives, OrbitDerivativesOf, ::testing::Values(unstable, large));

TEST(OrbitDerivativesTest, ByTheFrequencyAgreeWithDifferences) {
  const Isolator of;
  const PointResult found = orbit(of, large, {"frequency"});
  for (const std::string &field : measured) {
    const double exact = 2 * std::numbers::pi *
                         richardson(of, field_of(found, "state").values, "lambda", field, 1e-3);
    EXPECT_NEAR(value_of(found, "derivative/frequency/" + field), exact,
                1e-6 * std::max(1.0, std::abs(exact)))
        << field;
  }
}

// The value of a smooth extreme changes as the value at its fixed phase: by the variational
// equations from phase 0 to there, without any other motion.
TEST(OrbitDerivativesTest, OfAnExtremeValueByTheVariationalEquationsAlone) {
  const Isolator of;
  const PointResult found = orbit(of, large, {"stop"});
  const std::vector<double> &start = field_of(found, "state").values;
  const std::vector<double> &by_key = field_of(found, "derivative/stop/state").values;
  const System system = isolator(of);
  periodic::ForcedSystem forced(system.model, system.contacts, system.integration, 0);
  std::vector<motion::KeyNeighbour> near =
      key_neighbours({.path = "stop", .unit = "1", .values = {of.stop}}, of.stop,
                     [&](const std::vector<parameters::Override> &overrides) {
                       return isolator(changed(of, "stop", std::stod(overrides[0].value)));
                     });
  periodic::ForcedKey key = periodic::forced_key("stop", forced, std::move(near));
  periodic::StroboscopicMap map(forced, orbit_accuracy(system, forced));
  map.set_keys({&key});
  const Vector state = ConstVectorView(start.data(), 2);
  const auto speed = [&](double phase) { return map.carry(0, phase, state)[1]; };
  double low = -1, high = -1;
  for (double phase = 0.01; low < 0; phase += 0.01) // the largest displacement
    if (speed(phase) > 0 && speed(phase + 0.01) < 0 && map.carry(0, phase, state)[0] > 1)
      low = phase, high = phase + 0.01;
  for (int i = 0; i < 60; ++i)
    (speed(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  const periodic::Flow flow = map.flow(0, low, state);
  const Vector change = flow.by_state * ConstVectorView(by_key.data(), 2) + flow.by_keys.col(0);
  EXPECT_NEAR(value_of(found, "derivative/stop/point/block.head/displacement_x/maximum"), change[0],
              1e-8 * std::abs(change[0]));
}

// A motion that passes the stops by less than a thousandth of the clearance: with the clearance a
// little smaller it touches them.
TEST(OrbitDerivativesTest, ANeighbourWithOtherContactChangesIsSaid) {
  Isolator of{.lambda = 1.5};
  const PointResult free = orbit(of, {0, 0}, {});
  of.clearance = 1.0005 * value_of(free, measured[0]);
  const PointResult found = orbit(of, field_of(free, "state").values, {"clearance"});
  ASSERT_EQ(found.status, Status::finished) << found.reason;
  ASSERT_LT(value_of(found, measured[0]), of.clearance);
  EXPECT_EQ(value_of(found, "derivative/clearance/smooth"), 0);
}

} // namespace orbit_derivatives_tests
} // namespace vibroimpact::analyses
