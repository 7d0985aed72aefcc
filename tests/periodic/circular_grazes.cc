// Grazes of circular gaps, in closed form: a unit mass on equal springs and dashpots moves on the
// ellipse X cos(w t), Y sin(w t), X = a / |1 - w^2 + i c w|, in a ring of clearance 1 whose centre
// is 0.2 off along x. With Y = X / 2 it first touches where X = 0.8.
#include "continuation/branch.h"

#include "contact/laws/kelvin_voigt.h"
#include "family.h"
#include "support/circular_contacts.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace circular_grazes_tests {

using continuation::Branch;
using continuation::Special;
using testing::Family;
using testing::Oscillator;

constexpr double damping = 0.1, off = 0.2;

using Law = std::shared_ptr<const contact::ContactLaw>;

Oscillator in_ring(double a, double w, const Law &law) {
  Oscillator model{.model = model::Model({testing::isotropic("rotor", 1, 1, damping)})};
  const auto push = [&](const char *name, double size, double phase, const Vector3 &direction) {
    model.model.add_force(
        name, std::make_shared<model::Harmonic>(model::Given::displacement, size, w, phase),
        {.body = 0, .point = 0}, direction);
  };
  push("along", a, std::acos(0.0), Vector3::UnitX());
  push("across", a / 2, 0, Vector3::UnitY());
  model.contacts =
      contact::ContactSet({testing::ring_about_z(model.model, "rotor.head", "", 1, law, nullptr, 0,
                                                 contact::CircularGap::Kind::inside, {off, 0})});
  return model;
}

Branch from_before_touch(double w, const Law &law, double first) {
  Family family([&](double a) { return in_ring(a, w, law); }, false);
  const Orbit orbit = find_orbit(family.at(0.9 * first), 1, Vector::Zero(4));
  OrbitProblem problem(family, 2,
                       problem_sizes(family.at(0.9 * first), orbit, Vector::Constant(1, first)));
  continuation::Settings settings;
  settings.first_key = {.lower = 0.5 * first, .upper = 1.02 * first};
  return follow(problem,
                {.point = {.state = orbit.point.state,
                           .keys = Vector::Constant(1, 0.9 * first),
                           .chart = orbit.section.phase},
                 .direction = {}},
                settings);
}

void expect_first_touch(double w, const Law &law) {
  const double first = (1 - off) * std::hypot(1 - w * w, damping * w);
  const Branch branch = from_before_touch(w, law, first);
  EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
  ASSERT_EQ(branch.special.size(), 1u) << w;
  EXPECT_EQ(branch.special[0].kind, Special::graze);
  EXPECT_NEAR(branch.special[0].at.point.keys[0], first, 1e-11) << w;
}

TEST(CircularGrazesTest, FirstTouchOfARing) {
  expect_first_touch(0.6, std::make_shared<contact::LinearPenalty>(2));
  expect_first_touch(0.7, std::make_shared<contact::KelvinVoigt>(2, 0.4));
}

} // namespace circular_grazes_tests
} // namespace vibroimpact::periodic
