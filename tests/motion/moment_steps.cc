// Steps that no contact change ends: against closed forms, and against the exact method for laws of
// every kind.
#include "common/error.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "motion/event/impact_log.h"
#include "motion/moments/contact_course.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace moment_step_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

constexpr double pi = std::numbers::pi;

// Both ways to the responses, and where one takes over from the other.
TEST(MomentStepsResponseTest, IsTheIntegral) {
  for (const Complex z : {Complex(0, 0), Complex(-1e-3, 0.1), Complex(-1, 3.8), Complex(-1, 3.95),
                          Complex(-8, 0), Complex(-0.5, 30)})
    for (const double x : {0.07, 0.5, 1.0}) {
      const LegendreResponses found = legendre_responses(z, x);
      Matrix generator(2, 2);
      generator << z.real(), -z.imag(), z.imag(), z.real();
      const auto by_matrix = legendre_responses(generator, x);
      for (std::size_t k = 0; k < found.size(); ++k) {
        const auto part = [&](bool imaginary) {
          return boost::math::quadrature::gauss<double, 60>::integrate(
              [&](double s) {
                const Complex value = std::exp(z * (x - s)) * shifted_legendre(s)[k];
                return imaginary ? value.imag() : value.real();
              },
              0.0, x);
        };
        EXPECT_NEAR(found[k].real(), part(false), 2e-14) << z << " " << x << " " << k;
        EXPECT_NEAR(found[k].imag(), part(true), 2e-14) << z << " " << x << " " << k;
        EXPECT_NEAR(by_matrix[k](0, 0), found[k].real(), 5e-14);
        EXPECT_NEAR(by_matrix[k](1, 0), found[k].imag(), 5e-14);
      }
    }
}

// A gap that is a parabola, through a stop and back: the moments of its force are integrals of
// polynomials, and what the polynomial of the force lacks has no moments.
TEST(MomentStepsCourseTest, HasTheMomentsOfTheForce) {
  const LinearPenalty law(3);
  const auto gap = [](double x) { return (x - 0.3) * (x - 0.8); };
  constexpr double h = 0.2;
  GapValues values{.start = gap(0), .start_rate = -1.1 / h, .end = gap(1), .end_rate = 0.9 / h};
  for (std::size_t i = 0; i < n_moments; ++i)
    values.nodes[i] = gap(moment_nodes()[i]);
  ContactCourse course;
  ASSERT_TRUE(course.follow(law, GapCurve(values, h), 0));
  ASSERT_EQ(course.stretches().size(), 3u);
  EXPECT_NEAR(course.stretches()[1].from, 0.3, 1e-14);
  EXPECT_NEAR(course.stretches()[1].to, 0.8, 1e-14);
  LawResponse response;
  const ContactCourse::Moments moments = course.moments(law, response);
  EXPECT_NEAR(moments[0], 3 * std::pow(0.5, 3) / 6, 1e-15);
  EXPECT_NEAR(moments[1], 3 * 3 * std::pow(0.5, 3) / 6 * (2 * 0.55 - 1), 1e-15);
  const auto lacking = course.lacking(law, moments.data(), 1, response);
  EXPECT_NEAR(lacking[0], 0, 1e-16);
  EXPECT_NEAR(lacking[1], 0, 1e-16);
  const double impulse = course.integrals(law, course.stretches()[1], nullptr, response).force;
  EXPECT_NEAR(impulse, moments[0], 1e-15);
}

/// A free-free beam on a soft spring whose modes are cosines, above a row of equal stops.
struct BeamOnStops {
  int modes = 8, stops = 1;
  std::shared_ptr<const ContactLaw> law;
  double duration = 0.3;
  bool shaken = false; ///< the base moves instead of a force

  std::shared_ptr<const reduction::ReducedBody> body() const {
    auto beam = std::make_shared<reduction::ReducedBody>();
    beam->name = "beam";
    beam->type = "lumped";
    beam->mass = Vector::Ones(modes);
    beam->stiffness.resize(modes);
    beam->damping = Matrix::Zero(modes, modes);
    beam->base_participation = Matrix::Zero(modes, 3);
    beam->base_participation(0, 0) = 1;
    beam->total_mass = Vector3(1, 0, 0);
    Matrix rows = Matrix::Zero(6, modes);
    for (int k = 0; k < modes; ++k) {
      const double omega = k == 0 ? 6 * pi : 80 * pi * k * k;
      beam->stiffness[k] = omega * omega;
      beam->damping(k, k) = 0.06 * omega;
      rows(0, k) = shape(k, 0.4);
    }
    beam->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
    return beam;
  }
  static double shape(int k, double x) {
    return k == 0 ? 1 : std::sqrt(2.0) * std::cos(k * pi * x);
  }
  Model model() const {
    Model result({body()});
    const auto source =
        std::make_shared<Harmonic>(Given::displacement, shaken ? 3e-3 : 3.0, 8 * pi, 0);
    if (shaken)
      result.add_base_motion("table", source, {0}, Vector3::UnitX());
    else
      result.add_force("shaker", source, {.body = 0, .point = 0}, Vector3::UnitX());
    return result;
  }
  ContactSet contacts(const Model &of) const {
    std::vector<ContactPair> pairs;
    for (int i = 0; i < stops; ++i) {
      pairs.push_back(contact_along_x(of, "beam.head", "", 2e-3 + 2e-6 * ((7 * i) % stops), law));
      pairs.back().name = "stop " + std::to_string(i);
      for (int k = 0; k < modes; ++k)
        pairs.back().gap.row[k] = -shape(k, (i + 0.5) / stops);
    }
    return ContactSet(std::move(pairs));
  }
};

struct Seen {
  Vector state;
  std::vector<Impact> impacts;
  Accuracy accuracy;
};

Seen move(const BeamOnStops &system, const std::string &method, double tolerance,
          bool observed = true) {
  const Model model = system.model();
  const ContactSet contacts = system.contacts(model);
  Settings settings;
  settings.method = method;
  settings.relative_tolerance = tolerance;
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(0, Vector::Zero(model.size()), Vector::Zero(model.size()));
  ImpactLog log(contacts, 0);
  if (observed)
    trajectory.advance(system.duration, log);
  else
    trajectory.advance(system.duration);
  return {.state = trajectory.state().head(2 * model.size()),
          .impacts = log.impacts(0),
          .accuracy = trajectory.accuracy()};
}

double difference(const BeamOnStops &system, const Vector &a, const Vector &b) {
  const auto body = system.body();
  const auto norm = [&](const Vector &x) {
    const auto q = x.head(system.modes), v = x.tail(system.modes);
    return std::sqrt(q.cwiseAbs2().dot(body->stiffness) + v.squaredNorm());
  };
  return norm(a - b) / norm(b);
}

void expect_same_impacts(const std::vector<Impact> &found, const std::vector<Impact> &exact,
                         double tolerance) {
  ASSERT_EQ(found.size(), exact.size());
  ASSERT_GT(exact.size(), 0u);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(found[i].start_time, exact[i].start_time, tolerance * exact[i].start_time);
    EXPECT_NEAR(found[i].approach_speed, exact[i].approach_speed,
                tolerance * exact[i].approach_speed);
    EXPECT_NEAR(found[i].peak_force, exact[i].peak_force, tolerance * exact[i].peak_force);
    EXPECT_NEAR(found[i].impulse, exact[i].impulse, tolerance * exact[i].impulse);
  }
}

struct LawCase {
  const char *name;
  std::shared_ptr<const ContactLaw> (*make)(int stops);
};

class MomentStepsTest : public ::testing::TestWithParam<std::tuple<LawCase, int>> {};

// At 1e-9 the exact method is right to some 1e-12.
TEST_P(MomentStepsTest, AgreeWithTheExactMethod) {
  const auto &[law, stops] = GetParam();
  const BeamOnStops system{.stops = stops, .law = law.make(stops)};
  const Seen exact = move(system, "exact", 1e-12);
  const Seen found = move(system, "moments", 1e-9);
  EXPECT_LT(difference(system, found.state, exact.state), 1e-8);
  EXPECT_EQ(found.accuracy.events, exact.accuracy.events);
  EXPECT_LT(found.accuracy.energy_residual, 1e-8);
  expect_same_impacts(found.impacts, exact.impacts, 1e-7);
  const Seen unobserved = move(system, "moments", 1e-9, false);
  EXPECT_EQ(unobserved.state, found.state);
}

INSTANTIATE_TEST_SUITE_P(
    Laws, MomentStepsTest,
    ::testing::Combine(
        ::testing::Values(LawCase{"Linear",
                                  [](int stops) -> std::shared_ptr<const ContactLaw> {
                                    return std::make_shared<LinearPenalty>(2e6 / stops);
                                  }},
                          LawCase{"KelvinVoigt",
                                  [](int stops) -> std::shared_ptr<const ContactLaw> {
                                    return std::make_shared<KelvinVoigt>(2e6 / stops,
                                                                         200.0 / stops);
                                  }},
                          LawCase{"Hertz",
                                  [](int stops) -> std::shared_ptr<const ContactLaw> {
                                    return std::make_shared<Hertz>(
                                        HertzConstants{.stiffness = 2e9 / stops});
                                  }},
                          LawCase{"HuntCrossley",
                                  [](int stops) -> std::shared_ptr<const ContactLaw> {
                                    return HuntCrossley::with_dissipation(
                                        {.stiffness = 2e9 / stops}, 1);
                                  }}),
        ::testing::Values(1, 16)),
    [](const auto &info) {
      return std::string(std::get<0>(info.param).name) + std::to_string(std::get<1>(info.param));
    });

TEST(MomentStepsTest, MoveWithTheBase) {
  const BeamOnStops system{
      .stops = 5, .law = std::make_shared<LinearPenalty>(4e5), .duration = 0.6, .shaken = true};
  const Seen exact = move(system, "exact", 1e-12);
  const Seen found = move(system, "moments", 1e-9);
  EXPECT_LT(difference(system, found.state, exact.state), 1e-8);
  EXPECT_LT(found.accuracy.energy_residual, 1e-8);
  expect_same_impacts(found.impacts, exact.impacts, 1e-7);
}

// The error follows the tolerance over four orders.
TEST(MomentStepsTest, ErrFollowsTheTolerance) {
  const BeamOnStops system{.stops = 16, .law = std::make_shared<KelvinVoigt>(1.25e5, 12.5)};
  const Vector exact = move(system, "exact", 1e-12).state;
  for (const double tolerance : {1e-6, 1e-8, 1e-10})
    EXPECT_LT(difference(system, move(system, "moments", tolerance, false).state, exact),
              2 * tolerance)
        << tolerance;
}

// A free mass between two stops: rigid motion is a group of its own.
TEST(MomentStepsTest, AFreeMassBetweenStops) {
  const Model model({single_mass("block", 2, 0, 0)});
  const auto law = std::make_shared<LinearPenalty>(8e4);
  ContactPair other = contact_along_x(model, "block.head", "", 0.01, law);
  other.gap.row *= -1;
  const ContactSet contacts({contact_along_x(model, "block.head", "", 0.01, law), other});
  Settings settings;
  settings.method = "moments";
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 0.5));
  // Flights of 0.02 m and contacts of half a period of 200 rad/s.
  const double period = 2 * (0.02 / 0.5 + pi / 200);
  trajectory.advance(25 * period);
  EXPECT_NEAR(trajectory.state()[0], 0, 1e-8);
  EXPECT_NEAR(trajectory.state()[1], 0.5, 1e-8);
  EXPECT_EQ(trajectory.events(), 100);
}

// What cannot be done so is said.
TEST(MomentStepsTest, RefuseRigidContacts) {
  const Model model({single_mass("block", 1, 1, 0)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0, std::make_shared<NewtonRestitution>(0.5))});
  Settings settings;
  settings.method = "moments";
  EXPECT_THROW(Trajectory(model, contacts, settings), InputError);
}

} // namespace moment_step_tests
} // namespace vibroimpact::motion
