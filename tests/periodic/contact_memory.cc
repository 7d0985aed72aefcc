// What a contact remembers of its latest impact: a motion that does not touch is one motion,
// whatever an impact long ago has left.
#include "periodic/contact_memory.h"

#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "forced_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace contact_memory_tests {

using testing::ForcedMap;
using testing::Oscillator;
using testing::vector_of;

constexpr double stiffness = 40, damping = 0.8, omega = 5;

std::shared_ptr<const contact::ContactLaw> remembering() {
  return contact::HuntCrossley::with_dimensionless_damping({.stiffness = 4e4, .exponent = 1.5}, 0.5,
                                                           1e-3);
}

Oscillator with_stop(double force, const std::shared_ptr<const contact::ContactLaw> &law) {
  Oscillator model = testing::oscillator(1, stiffness, damping);
  model.push(force, omega);
  model.stop({{0.1, law}});
  return model;
}

std::vector<Index> idle_at(const std::shared_ptr<const contact::ContactLaw> &law,
                           const Vector &state) {
  const Oscillator model = with_stop(1, law);
  ForcedMap forced(model, false);
  return forced.map.idle(0, state);
}

TEST(ContactMemoryTest, OnlyWhatNothingSees) {
  EXPECT_EQ(idle_at(remembering(), vector_of({0, 0, 0.3})), std::vector<Index>{2});
  EXPECT_TRUE(idle_at(remembering(), vector_of({0.11, 0, 0.3})).empty());
  const auto relaxing = std::make_shared<contact::KelvinVoigtBumper>(40.0, 1.0);
  EXPECT_TRUE(idle_at(relaxing, vector_of({0, 0, 0.01})).empty());
}

// x = a sin(w t - phi), a = f / |k - w^2 + i c w|; multipliers exp(-c T / 2) e^(+-i w_d T), and 0.
TEST(ContactMemoryTest, MotionsWithoutContactAreOne) {
  constexpr double force = 0.9;
  const double amplitude = force / std::hypot(stiffness - omega * omega, damping * omega);
  ASSERT_LT(amplitude, 0.1);
  const Oscillator model = with_stop(force, remembering());
  ForcedMap forced(model, false);
  for (const double speed : {0.2, 3.0}) {
    const Orbit orbit = find_orbit(forced.map, 1, vector_of({0, 0, speed}));
    EXPECT_NEAR(std::hypot(orbit.point.state[0], orbit.point.state[1] / omega), amplitude, 1e-12);
    EXPECT_EQ(orbit.point.state[2], 0);
    const Eigen::VectorXcd multipliers = orbit.multipliers(forced.map);
    const double size = std::exp(-damping / 2 * 2 * std::numbers::pi / omega);
    EXPECT_NEAR(std::abs(multipliers[0]), size, 1e-12);
    EXPECT_NEAR(std::abs(multipliers[1]), size, 1e-12);
    EXPECT_EQ(multipliers[2], 0.0);
  }
}

} // namespace contact_memory_tests
} // namespace vibroimpact::periodic
