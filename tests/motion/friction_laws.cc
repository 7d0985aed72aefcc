// Spring-sliders and viscous friction, and friction under normal laws that let go, against closed
// forms.
#include "contact/friction/spring_slider.h"
#include "contact/friction/viscous.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "model/time_function.h"
#include "support/friction_by_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace friction_laws_tests {

using namespace model;
using contact::ContactSet;
using contact::Coulomb;
using contact::FrictionalLaw;
using contact::KelvinVoigt;
using contact::LinearPenalty;
using contact::SpringSlider;
using contact::Viscous;
using testing::Changes;
using testing::constant_with;
using testing::oblique_contact;
using testing::particle;
using testing::single_mass;
using testing::sliding_along_x;
using testing::vector_of;
constexpr double pi = std::numbers::pi;

class FrictionLawsTest : public testing::FrictionByMethod {
protected:
  double error() const { return FrictionByMethod::error(1e-12); }
};
INSTANTIATE_TEST_SUITE_P(Methods, FrictionLawsTest, ::testing::Values("exact", "rk"));

// A mass on a spring k, held by a spring kt that yields at mu N: sticks, slides to its turning
// point, sticks there, and so on. Between changes all is harmonic about a known centre.
TEST_P(FrictionLawsTest, SpringSliderOnAFreeMass) {
  const double k = 1e4, kt = 4e5, limit = 1, start = 8.5e-4;
  const Model model({single_mass("block", 1, k, 0)});
  const ContactSet contacts({sliding_along_x(
      model, "block.head", "", constant_with(10, std::make_shared<SpringSlider>(kt, 0.1, 0)))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({start}), vector_of({0}));
  trajectory.advance(0.06, changes);
  double x = start, time = 0, pulled = 0; // by the spring, in its deformation; towards -x
  double sign = 1;                        // of the motion to come, towards -x
  ASSERT_GE(changes.list.size(), 3u);
  for (std::size_t i = 0; i + 1 < changes.list.size(); i += 2) {
    const double w = std::sqrt(k + kt);
    const double way = limit / kt - pulled;
    const double centre = (kt * (sign * x - pulled)) / (k + kt); // along the motion reversed
    const double amplitude = sign * x - centre;
    const double angle = std::acos(1 - way / amplitude);
    time += angle / w;
    EXPECT_NEAR(changes.list[i].time, time, error() * 0.06) << i;
    EXPECT_NE(changes.list[i].to, "stick");
    const double y = sign * x - way, v = amplitude * w * std::sin(angle);
    const double free = std::hypot(y - limit / k, v / std::sqrt(k));
    time += (pi - std::atan2(v / std::sqrt(k), y - limit / k)) / std::sqrt(k);
    x = sign * (limit / k - free);
    EXPECT_NEAR(changes.list[i + 1].time, time, error() * 0.06) << i;
    EXPECT_NEAR(changes.list[i + 1].state[0], x, error() * start) << i;
    EXPECT_EQ(changes.list[i + 1].to, "stick");
    sign = -sign;
    pulled = -limit / kt;
  }
  EXPECT_LT(trajectory.accuracy().energy_residual, error());
}

// With a dashpot beside its spring the ringing after a stop dies out, and energy is accounted for.
TEST_P(FrictionLawsTest, SpringSliderWithADashpotComesToRest) {
  const double k = 1e4, kt = 4e5;
  const Model model({single_mass("block", 1, k, 0)});
  const ContactSet contacts({sliding_along_x(
      model, "block.head", "", constant_with(10, std::make_shared<SpringSlider>(kt, 0.1, 200)))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({8.5e-4}), vector_of({0}));
  trajectory.advance(0.8, changes);
  const Vector &x = trajectory.state();
  EXPECT_EQ(changes.list.back().to, "stick");
  EXPECT_NEAR(x[1], 0, error());
  EXPECT_NEAR(k * x[0], kt * x[trajectory.layout().internal()], error() * kt * 8.5e-4);
  EXPECT_LT(trajectory.accuracy().energy_residual, error());
}

// The largest terms of what a slider with a dashpot takes cancel; what is left is still a quadratic
// form, and energy is accounted for.
TEST_P(FrictionLawsTest, SpringSliderWithADashpotUnderADampedNormalForce) {
  const Model model({particle("ball", 1.72)});
  const ContactSet contacts({oblique_contact(
      model, "ball.head", 0,
      std::make_shared<FrictionalLaw>(std::make_shared<KelvinVoigt>(7250.4, 3.6656),
                                      std::make_shared<SpringSlider>(8840.3, 0.20374, 0.2437)))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({0.5, 1}));
  trajectory.advance(0.1, changes);
  EXPECT_EQ(changes.list.back().to, "open");
  EXPECT_LT(trajectory.accuracy().energy_residual, error());
}

// A mass that rests on a shaken stop slides as the stop moves: it cannot stick.
TEST_P(FrictionLawsTest, MassOnAShakenStopBesideTheGround) {
  const double amplitude = 1e-3, w = 40;
  Model model({single_mass("block", 2, 0, 0)});
  testing::add_weight(model, 9.81, {0});
  model.add_base_motion("base",
                        std::make_shared<Harmonic>(Given::displacement, amplitude, w, pi / 3), {0},
                        Vector3::UnitX());
  const ContactSet contacts(
      {testing::stop_on_base(model, "block.head", 0, testing::newton(0.5)),
       sliding_along_x(model, "block.head", "", testing::coulomb(2, 0.4, 0.5))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(10 * pi / w, changes);
  EXPECT_EQ(changes.list.size(), 10u);
  EXPECT_NEAR(trajectory.state()[0], 0, error() * amplitude);
  EXPECT_NEAR(trajectory.state()[trajectory.layout().sliding_way(0)], 20 * amplitude,
              error() * amplitude);
}

// The contact lasts until the damped normal force ends, where the acceleration is zero.
TEST_P(FrictionLawsTest, ViscousFrictionUnderADampedNormalForce) {
  const double m = 2, k = 3e4, c = 60, ct = 5, vt = 0.7;
  const Model model({particle("ball", m)});
  const ContactSet contacts(
      {oblique_contact(model, "ball.head", 0,
                       std::make_shared<FrictionalLaw>(std::make_shared<KelvinVoigt>(k, c),
                                                       std::make_shared<Viscous>(ct)))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({vt, 1}));
  trajectory.advance(0.1, changes);
  const double d = c / m / 2, w = std::sqrt(k / m - d * d);
  const double end = (pi + std::atan(2 * d * w / (d * d - w * w))) / w;
  EXPECT_NEAR(trajectory.state()[2], vt * std::exp(-ct / m * end), error());
  EXPECT_LT(trajectory.accuracy().energy_residual, error());
}

// A mass slides against a rigid stop beside it: friction turns with the rebound, and the mass comes
// to rest.
TEST_P(FrictionLawsTest, RigidStopBesideASlidingContact) {
  const double deceleration = 0.4, way = 0.3, v = 1, e = 0.6;
  const Model model({single_mass("block", 2, 0, 0)});
  const ContactSet contacts(
      {testing::contact_along_x(model, "block.head", "", way, testing::newton(e)),
       sliding_along_x(model, "block.head", "", testing::coulomb(2, deceleration, 0.5))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0}), vector_of({v}));
  trajectory.advance(5, changes);
  const double meets = std::sqrt(v * v - 2 * deceleration * way);
  EXPECT_NEAR(trajectory.state()[0], way - e * e * meets * meets / 2 / deceleration, error());
  EXPECT_EQ(trajectory.state()[1], 0);
  ASSERT_GE(changes.list.size(), 2u);
  EXPECT_NEAR(changes.list[0].time, (v - meets) / deceleration, error());
  EXPECT_NEAR(changes.list.back().time, (v - meets + e * meets) / deceleration, error());
  EXPECT_EQ(changes.list.back().to, "stick");
  EXPECT_NEAR(trajectory.state()[trajectory.layout().wear_work(0)],
              2 * (way + e * e * meets * meets / 2 / deceleration), error());
}

TEST_P(FrictionLawsTest, ViscousFrictionDampsAMass) {
  const double k = 100, c = 3;
  const Model model({single_mass("block", 1, k, 0)});
  const ContactSet contacts(
      {sliding_along_x(model, "block.head", "", constant_with(10, std::make_shared<Viscous>(c)))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({1}), vector_of({0}));
  trajectory.advance(2, changes);
  const double w = std::sqrt(k - c * c / 4);
  EXPECT_NEAR(trajectory.state()[0], std::exp(-c) * (std::cos(2 * w) + c / 2 / w * std::sin(2 * w)),
              error());
  EXPECT_LT(trajectory.accuracy().energy_residual, error());
}

// A particle meets a spring at an angle: half a period of normal force, whose impulse times the
// coefficient is what the tangential momentum loses, or all of it where it comes to stick.
TEST_P(FrictionLawsTest, ObliqueImpactOnASpring) {
  const double m = 2, kn = 3e4, vn = 1, mu = 0.3;
  const double w = std::sqrt(kn / m);
  for (const double vt : {0.9, 0.5}) {
    const Model model({particle("ball", m)});
    const ContactSet contacts(
        {oblique_contact(model, "ball.head", 0.1,
                         std::make_shared<FrictionalLaw>(std::make_shared<LinearPenalty>(kn),
                                                         std::make_shared<Coulomb>(mu, mu)))});
    Trajectory trajectory(model, contacts, settings());
    Changes changes(contacts);
    trajectory.start(0, vector_of({0, 0}), vector_of({vt, vn}));
    trajectory.advance(0.2, changes);
    const bool sticks = vt < 2 * mu * vn;
    const double after = sticks ? 0 : vt - 2 * mu * vn;
    ASSERT_EQ(changes.list.size(), sticks ? 3u : 2u) << vt;
    EXPECT_EQ(changes.list[0].to, "slip backward");
    EXPECT_NEAR(changes.list[0].time, 0.1, error());
    EXPECT_NEAR(changes.list.back().time, 0.1 + pi / w, error());
    EXPECT_NEAR(trajectory.state()[2], after, error());
    EXPECT_NEAR(trajectory.state()[3], -vn, error());
    if (sticks) {
      EXPECT_EQ(changes.list[1].to, "stick");
      EXPECT_NEAR(changes.list[1].time, 0.1 + std::acos(1 - vt / (mu * vn)) / w, error());
    }
    EXPECT_NEAR(trajectory.state()[trajectory.layout().friction_work(0)],
                m / 2 * (vt * vt - after * after), error());
    EXPECT_LT(trajectory.accuracy().energy_residual, error());
  }
}

// With a dashpot the force begins with a jump and is cut off; the impulse decides all the same.
TEST_P(FrictionLawsTest, ObliqueImpactOnASpringWithADashpot) {
  const double m = 2, mu = 0.3, vt = 0.9;
  const Model model({particle("ball", m)});
  const ContactSet contacts(
      {oblique_contact(model, "ball.head", 0.1,
                       std::make_shared<FrictionalLaw>(std::make_shared<KelvinVoigt>(3e4, 90),
                                                       std::make_shared<Coulomb>(mu, mu)))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({vt, 1}));
  trajectory.advance(0.2, changes);
  const double impulse = trajectory.state()[trajectory.layout().impulse(0)];
  EXPECT_GT(impulse, m);
  EXPECT_NEAR(m * (vt - trajectory.state()[2]), mu * impulse, error());
  EXPECT_LT(trajectory.accuracy().energy_residual, error());
}

TEST_P(FrictionLawsTest, ObliqueImpactWithViscousFriction) {
  const double m = 2, kn = 3e4, c = 40, vt = 0.9;
  const Model model({particle("ball", m)});
  const ContactSet contacts(
      {oblique_contact(model, "ball.head", 0.1,
                       std::make_shared<FrictionalLaw>(std::make_shared<LinearPenalty>(kn),
                                                       std::make_shared<Viscous>(c)))});
  Trajectory trajectory(model, contacts, settings());
  trajectory.start(0, vector_of({0, 0}), vector_of({vt, 1}));
  trajectory.advance(0.2);
  EXPECT_NEAR(trajectory.state()[2], vt * std::exp(-c / m * pi / std::sqrt(kn / m)), error());
}

// While the sides are bonded the tangential velocity swings on the tangential spring (Walton's
// form); what is left in the spring at the release goes, as the slider gives way, with 1 / mu.
TEST_P(FrictionLawsTest, ObliqueImpactWithATangentialSpring) {
  const double m = 2, kn = 3e4, vt = 0.9;
  double before = 0;
  for (const double mu : {1e2, 1e4}) {
    const double ratio = 0.5;
    const Model model({particle("ball", m)});
    const ContactSet contacts({oblique_contact(
        model, "ball.head", 0.1,
        std::make_shared<FrictionalLaw>(std::make_shared<LinearPenalty>(kn),
                                        std::make_shared<SpringSlider>(ratio * kn, mu, 0)))});
    Trajectory trajectory(model, contacts, settings());
    Changes changes(contacts);
    trajectory.start(0, vector_of({0, 0}), vector_of({vt, 1}));
    trajectory.advance(0.2, changes);
    const double off = trajectory.state()[2] - vt * std::cos(pi * std::sqrt(ratio));
    EXPECT_EQ(changes.list[0].to, "stick");
    EXPECT_LT(std::abs(off), 3 / mu);
    if (before != 0) {
      EXPECT_NEAR(off / before, 0.01, 0.001);
    }
    before = off;
    // The power of the slider is a product of forms of size mu, whose terms cancel.
    EXPECT_LT(trajectory.accuracy().energy_residual, error() + 1e-15 * mu * mu);
  }
}

} // namespace friction_laws_tests
} // namespace vibroimpact::motion
