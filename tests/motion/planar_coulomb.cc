// Coulomb's friction along two directions with stick, against closed forms, against figures of an
// independent program (tests/support/planar_friction_reference.py), and against friction along one
// direction where the motion keeps to one.
#include "contact/friction/planar_coulomb.h"
#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt.h"
#include "support/planar_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace planar_coulomb_tests {

using namespace model;
using contact::ContactLaw;
using contact::ContactSet;
using contact::Coulomb;
using contact::CoulombConstants;
using contact::FrictionalLaw;
using contact::KelvinVoigt;
using contact::PlanarCoulomb;
using testing::across_the_ground;
using testing::Changes;
using testing::constant_with;
using testing::on_the_ground;
using testing::precise;
using testing::Sled;
using testing::sled_model;
using testing::vector_of;

std::shared_ptr<const ContactLaw> pressed_with(double coefficient, double static_coefficient) {
  return constant_with(10,
                       std::make_shared<PlanarCoulomb>(CoulombConstants{
                           .coefficient = coefficient, .static_coefficient = static_coefficient}));
}

class PlanarCoulombTest : public ::testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(Methods, PlanarCoulombTest, ::testing::Values("exact", "rk"));

/// A stop under a constant acceleration a along x and the deceleration f: with psi the angle of the
/// slip rate against x, u = ln tan(psi / 2) and r = f / a it is |v| = C e^(r u) cosh u.
struct Stop {
  double time, x, y;

  Stop(double f, double a, double speed, double angle) {
    const double r = f / a;
    const double u = std::log(std::tan(angle / 2));
    const double c = speed / (std::exp(r * u) * std::cosh(u));
    time = (f + a * std::cos(angle)) * speed / (f * f - a * a);
    x = -c * c / (4 * a) *
        (std::exp((2 * r + 2) * u) / (2 * r + 2) - std::exp((2 * r - 2) * u) / (2 * r - 2));
    y = c * c / (2 * a) *
        (std::exp((2 * r + 1) * u) / (2 * r + 1) + std::exp((2 * r - 1) * u) / (2 * r - 1));
  }
};

TEST_P(PlanarCoulombTest, StopsUnderAConstantForce) {
  const bool exact = std::string(GetParam()) == "exact";
  for (const double ratio : {0.1, 0.3, 0.5, 0.8, 0.95})
    for (const double angle : {0.5, 1.5, 2.5}) {
      SCOPED_TRACE(std::to_string(ratio) + " " + std::to_string(angle));
      const double f = 2, speed = 1.3;
      const Stop stop(f, ratio * f, speed, angle);
      const Sled sled{.mass = 2, .pull_x = 2 * ratio * f};
      const Model model = sled_model(sled);
      const ContactSet contacts(
          {on_the_ground(model, pressed_with(0.4, 0.4), across_the_ground())});
      Trajectory trajectory(model, contacts, precise(GetParam()));
      Changes changes(contacts);
      trajectory.start(0, vector_of({0, 0, 0}),
                       vector_of({speed * std::cos(angle), speed * std::sin(angle), 0}));
      trajectory.advance(2 * stop.time, changes);
      ASSERT_FALSE(changes.list.empty());
      EXPECT_EQ(changes.list.back().to, "stick");
      EXPECT_NEAR(changes.list.back().time, stop.time, exact ? 1e-12 : 1e-8);
      const Vector &x = trajectory.state();
      EXPECT_NEAR(x[0], stop.x, exact ? 1e-11 : 1e-8);
      EXPECT_NEAR(x[1], stop.y, exact ? 1e-11 : 1e-8);
      EXPECT_EQ(x.segment(3, 2), vector_of({0, 0}));
      EXPECT_LT(trajectory.accuracy().energy_residual, exact ? 1e-11 : 1e-8);
    }
}

/// Several contacts of the sled, each with this part of the normal force and its directions turned
/// by as many radians as it has contacts before it.
ContactSet parted(const Model &model, const std::vector<double> &parts, double static_coefficient) {
  std::vector<contact::ContactPair> pairs;
  for (const double part : parts) {
    const auto turn = static_cast<double>(pairs.size());
    pairs.push_back(on_the_ground(
        model,
        constant_with(10 * part,
                      std::make_shared<PlanarCoulomb>(CoulombConstants{
                          .coefficient = 0.1, .static_coefficient = static_coefficient})),
        {Vector3(std::cos(turn), std::sin(turn), 0), Vector3(-std::sin(turn), std::cos(turn), 0)}));
    pairs.back().name += std::to_string(pairs.size());
  }
  return ContactSet(std::move(pairs));
}

// They stop, hold and start together as one contact with the sum of their forces does.
TEST_P(PlanarCoulombTest, ContactsOfTheSameSidesAreOne) {
  const Sled sled{.mass = 1, .kx = 1, .ky = 1.7, .driven = true};
  const Model model = sled_model(sled);
  for (const double static_coefficient : {0.1, 0.12}) {
    Vector whole;
    for (const std::vector<double> &parts :
         std::vector<std::vector<double>>{{1}, {0.35, 0.65}, {0.02, 0.98}, {0.2, 0.5, 0.3}}) {
      SCOPED_TRACE(std::to_string(parts.size()) + " " + std::to_string(parts.front()));
      const ContactSet contacts = parted(model, parts, static_coefficient);
      Trajectory trajectory(model, contacts, precise(GetParam()));
      Changes changes(contacts);
      trajectory.start(0, vector_of({1.5, 0.5, 0}), vector_of({0.2, -1, 0}));
      trajectory.advance(11, changes);
      if (whole.size() == 0)
        whole = trajectory.state().head(6);
      // Where the coefficients are equal the instant at which a break-away begins is uncertain.
      EXPECT_LT((trajectory.state().head(6) - whole).norm(),
                static_coefficient > 0.1 ? 1e-12 : 1e-10);
      EXPECT_LT(trajectory.accuracy().energy_residual, 2e-12);
    }
  }
}

/// Changes between stick and slip, with the place there.
struct Place {
  double time, x, y;
};

struct Case {
  double static_coefficient;
  std::vector<Place> changes; ///< sticks and slips in turn
  double last[4];             ///< x, y, x', y'
};

TEST_P(PlanarCoulombTest, UnderATurningForce) {
  const Case cases[] = {
      {0.12,
       {{5.36902679444785, -0.794767554765927, -0.246713445159219},
        {6.46627756180545, -0.794767554765927, -0.246713445159219},
        {9.59346855410973, 0.470978465933365, 0.289549956432635},
        {10.8541919133935, 0.470978465933365, 0.289549956432635},
        {13.6160179892362, -0.260532255169742, -0.19992683860758},
        {15.2651379844812, -0.260532255169742, -0.19992683860758}},
       {-0.197539025502304, -0.164834381168545, 0.176251852108885, 0.10923518444173}},
      {0.1,
       {{5.36902679444785, -0.794767554765927, -0.246713445159219},
        {6.17805916162934, -0.794767554765927, -0.246713445159219},
        {9.5728393377279, 0.471619099597751, 0.282778494484427},
        {10.552211907362, 0.471619099597751, 0.282778494484427},
        {13.5854881739229, -0.26457136094965, -0.193737108958803},
        {14.858214494118, -0.26457136094965, -0.193737108958803}},
       {-0.172257874704953, -0.146233761866632, 0.198961142226811, 0.119043127464743}}};
  for (const Case &of : cases) {
    SCOPED_TRACE(of.static_coefficient);
    const Sled sled{.mass = 1, .kx = 1, .ky = 1.7, .driven = true};
    const Model model = sled_model(sled);
    const ContactSet contacts(
        {on_the_ground(model, pressed_with(0.1, of.static_coefficient), across_the_ground())});
    Trajectory trajectory(model, contacts, precise(GetParam()));
    Changes changes(contacts);
    trajectory.start(0, vector_of({1.5, 0.5, 0}), vector_of({0.2, -1, 0}));
    trajectory.advance(16, changes);
    std::erase_if(changes.list, [](const Changes::Change &change) {
      return change.to != "stick" && change.from != "stick";
    });
    ASSERT_EQ(changes.list.size(), of.changes.size());
    const double error = std::string(GetParam()) == "exact" ? 1e-10 : 1e-8;
    for (std::size_t i = 0; i < of.changes.size(); ++i) {
      EXPECT_NEAR(changes.list[i].time, of.changes[i].time, error) << i;
      EXPECT_NEAR(changes.list[i].state[0], of.changes[i].x, error) << i;
      EXPECT_NEAR(changes.list[i].state[1], of.changes[i].y, error) << i;
    }
    const Vector &x = trajectory.state();
    EXPECT_NEAR(x[0], of.last[0], error);
    EXPECT_NEAR(x[1], of.last[1], error);
    EXPECT_NEAR(x[3], of.last[2], error);
    EXPECT_NEAR(x[4], of.last[3], error);
    EXPECT_LT(trajectory.accuracy().energy_residual, error);
  }
}

// Friction along one direction says all where the motion keeps to one, in flight against a side
// too.
TEST_P(PlanarCoulombTest, MotionAlongOneDirection) {
  const std::vector<std::shared_ptr<const ContactLaw>> normals = {
      std::make_shared<KelvinVoigt>(3e4, 90),
      std::make_shared<contact::Hertz>(contact::HertzConstants{.stiffness = 1e5})};
  for (const auto &normal : normals)
    for (const double static_coefficient : {0.3, 0.4}) {
      SCOPED_TRACE(normal->name() + " " + std::to_string(static_coefficient));
      EXPECT_LT(testing::apart_along_one_direction(
                    normal, std::make_shared<Coulomb>(0.3, static_coefficient, 5),
                    std::make_shared<PlanarCoulomb>(
                        CoulombConstants{.coefficient = 0.3,
                                         .static_coefficient = static_coefficient,
                                         .damping_constant = 5}),
                    GetParam()),
                1e-8);
    }
}

/// A sphere of radius R on the ground: x, y and its rotations about x and y.
struct Sphere {
  double mass = 1, radius = 0.5;
  double inertia() const { return 0.4 * mass * radius * radius; }

  Model model() const {
    auto body = std::make_shared<reduction::ReducedBody>();
    body->name = "sphere";
    body->type = "lumped";
    body->mass = Vector{{mass, mass, inertia(), inertia()}};
    body->stiffness = Vector::Zero(4);
    body->damping = Matrix::Zero(4, 4);
    body->base_participation = Matrix::Zero(4, 3);
    body->total_mass = Vector3::Constant(mass);
    Matrix rows = Matrix::Zero(6, 4);
    rows(0, 0) = rows(1, 1) = rows(3, 2) = rows(4, 3) = 1;
    body->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
    return Model({body});
  }

  /// The ground lies at R along z: its point of contact has u + theta x R e_z.
  contact::ContactPair contact(const Model &model, std::shared_ptr<const ContactLaw> law) const {
    contact::ContactPair pair =
        testing::contact_along_x(model, "sphere.head", "", 0, std::move(law));
    pair.tangential.resize(2, {.slip = pair.gap});
    pair.gap.row.setZero();
    pair.tangential[0].slip.row = RowVector{{-1, 0, 0, -radius}};
    pair.tangential[1].slip.row = RowVector{{0, -1, radius, 0}};
    return pair;
  }
};

// The slip u = v + theta' x R e_z of a solid sphere keeps its direction and loses 7/2 mu g, so that
// it rolls after 2 |u| / (7 mu g) with v - 2/7 u; until then its centre goes along a parabola.
TEST_P(PlanarCoulombTest, SphereSlidesUntilItRolls) {
  const bool exact = std::string(GetParam()) == "exact";
  const Sphere sphere;
  const Model model = sphere.model();
  const ContactSet contacts({sphere.contact(model, pressed_with(0.3, 0.3))});
  Trajectory trajectory(model, contacts, precise(GetParam()));
  Changes changes(contacts);
  const Eigen::Vector2d v(1, 0.4), spin(2, -3);
  trajectory.start(0, Vector::Zero(4), vector_of({v[0], v[1], spin[0], spin[1]}));
  const Eigen::Vector2d slip = v + sphere.radius * Eigen::Vector2d(spin[1], -spin[0]);
  const double decay = 0.3 * 10 / sphere.mass;
  const double rolls = 2 * slip.norm() / (7 * decay);
  const double end = 2 * rolls;
  trajectory.advance(end, changes);
  ASSERT_FALSE(changes.list.empty());
  EXPECT_EQ(changes.list.back().to, "stick");
  EXPECT_NEAR(changes.list.back().time, rolls, exact ? 1e-12 : 1e-8);
  const Vector &x = trajectory.state();
  const Eigen::Vector2d rolling = v - 2.0 / 7 * slip;
  const Eigen::Vector2d place =
      v * rolls - 0.5 * decay * rolls * rolls * slip.normalized() + rolling * (end - rolls);
  for (Index i = 0; i < 2; ++i) {
    EXPECT_NEAR(x[4 + i], rolling[i], exact ? 1e-12 : 1e-8);
    EXPECT_NEAR(x[i], place[i], exact ? 1e-11 : 1e-8);
  }
  EXPECT_NEAR(x[4] + sphere.radius * x[7], 0, 1e-14);
  EXPECT_NEAR(x[5] - sphere.radius * x[6], 0, 1e-14);
  const StateLayout &layout = trajectory.layout();
  EXPECT_NEAR(x[layout.friction_work(0)], sphere.mass * slip.squaredNorm() / 7,
              exact ? 1e-11 : 1e-8);
  EXPECT_NEAR(x[layout.wear_work(0)] * 0.3, x[layout.friction_work(0)], exact ? 1e-11 : 1e-8);
  EXPECT_NEAR(x[layout.sliding_way(0)], slip.norm() * rolls / 2, exact ? 1e-11 : 1e-8);
}

} // namespace planar_coulomb_tests
} // namespace vibroimpact::motion
