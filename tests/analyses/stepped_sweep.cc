// The isolator with a damped elastic stop, y'' + h(y') + g(y) = f sin(lambda t): outside |y| = 1
// the stop adds stiffness mu and damping. Folds of its response from shooting with saltation
// (independent of this program): lambda = 1.231279272 and 1.362748253 for f = 0.52, mu = 2.
#include "analyses/sweeps/stepped_sweep.h"

#include "common/error.h"
#include "contact/laws/bilinear_stop.h"
#include "support/lumped_models.h"
#include "support/points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace vibroimpact::analyses {
namespace stepped_sweep_tests {

using namespace contact;
using namespace model;

constexpr double pi = std::numbers::pi;
constexpr double lower_fold = 1.231279272, upper_fold = 1.362748253;

System isolator(double lambda) {
  Model model({testing::single_mass("mass", 1, 1, 2 * 0.01)});
  model.add_force("push", std::make_shared<Harmonic>(Given::displacement, 0.52, lambda, 0), {},
                  Vector3::UnitX());
  const auto law = std::make_shared<BilinearStop>(2, 2 * 0.2);
  ContactPair right = testing::contact_along_x(model, "mass.head", "", 1, law);
  ContactPair left = right;
  right.name = "right";
  left.name = "left";
  left.gap.row *= -1;
  return {.model = std::move(model),
          .contacts = ContactSet({right, left}),
          .integration = {.relative_tolerance = 1e-9},
          .initial = {.displacement = Vector::Zero(1), .velocity = Vector::Zero(1)}};
}

SteppedSweep::Settings sweep(double first, double last, std::size_t points) {
  SteppedSweep::Settings settings{
      .parameter = {},
      .directions = SteppedSweep::Directions::both,
      .backward_from_rest = false,
      .settling = {.minimum = 5, .maximum = 600, .tolerance = 1e-6, .longest_multiple = 4},
      .recorded = 2,
      .excitation = {},
      .jump_tolerance = 0,
      .jump_threshold = 0.05};
  for (std::size_t i = 0; i < points; ++i)
    settings.parameter.values.push_back(
        (first + (last - first) * static_cast<double>(i) / static_cast<double>(points - 1)) /
        (2 * pi));
  return settings;
}

double peak(const testing::Points &points, const std::vector<std::size_t> &index) {
  return points.value(index, "point/mass.head/displacement_x/largest");
}

// Brackets of both directions, as (from, to) in lambda, one per jump.
std::vector<std::pair<double, double>> jumps(const testing::Points &points) {
  std::vector<std::pair<double, double>> found;
  for (const auto &[index, result] : points.all()) {
    EXPECT_EQ(result.status, Status::finished) << index[0] << " " << result.reason;
    if (result.status == Status::finished && !std::isnan(points.value(index, "jump_from")))
      found.emplace_back(2 * pi * points.value(index, "jump_from"),
                         2 * pi * points.value(index, "jump_to"));
  }
  return found;
}

TEST(SteppedSweepTest, ItsJumpsAreBracketedAtTheFolds) {
  SteppedSweep::Settings settings = sweep(1.20, 1.40, 6);
  settings.jump_tolerance = 2e-6;
  System system = isolator(1);
  testing::Points points;
  SteppedSweep(settings).run_line(0, system, points);
  const auto found = jumps(points);
  ASSERT_EQ(found.size(), 2u);
  const auto [up_from, up_to] = found[1].first > 1.3 ? found[1] : found[0];
  const auto [down_from, down_to] = found[1].first > 1.3 ? found[0] : found[1];
  EXPECT_NEAR(up_to, upper_fold, 1e-4);
  EXPECT_NEAR(down_to, lower_fold, 1e-4);
  EXPECT_LT(up_to - up_from, 2e-6 * 1.4 * 1.001);
  EXPECT_LT(down_from - down_to, 2e-6 * 1.4 * 1.001);
}

class Shares : public testing::Points {
public:
  void note_progress(double share) override { largest = std::max(largest, share); }
  double largest = 0;
};

// A point that settles has a part of its longest motion behind it, and the search adds nothing.
TEST(SteppedSweepTest, TheSearchForAJumpHasNoShareOfItsOwn) {
  SteppedSweep::Settings settings = sweep(1.20, 1.40, 6);
  settings.jump_tolerance = 2e-6;
  System system = isolator(1);
  Shares points;
  SteppedSweep(settings).run_line(0, system, points);
  EXPECT_EQ(jumps(points).size(), 2u);
  EXPECT_GT(points.largest, 0);
  EXPECT_LT(points.largest, 1);
}

TEST(SteppedSweepTest, BothStableOrbitsBetweenTheFolds) {
  System system = isolator(1);
  testing::Points points;
  SteppedSweep(sweep(1.20, 1.40, 5)).run_line(0, system, points);
  EXPECT_NEAR(peak(points, {2, 0}), 2.03017588, 1e-5);
  EXPECT_NEAR(peak(points, {2, 1}), 0.75308873, 1e-5);
}

// Turned between the folds, the backward sweep goes on from the end of the forward one, on the same
// orbit; begun from the initial conditions, which are those of the orbit without contact there, it
// would be on the other.
TEST(SteppedSweepTest, TheBackwardSweepGoesOnWhereTheForwardOneEnds) {
  const SteppedSweep::Settings turned = sweep(1.20, 1.30, 5);
  System system = isolator(1);
  system.initial.velocity[0] = 0.52 * 1.30 / (1 - 1.30 * 1.30);
  testing::Points points;
  SteppedSweep(turned).run_line(0, system, points);
  for (const std::size_t point : {2u, 3u, 4u})
    EXPECT_NEAR(peak(points, {point, 1}), peak(points, {point, 0}), 1e-5) << point;
  EXPECT_NEAR(peak(points, {4, 1}), 2.03017588, 1e-5);
}

// From rest every point is the only one of its line and equals a motion of its own.
TEST(SteppedSweepTest, FromTheInitialConditionsNoPointKnowsTheOthers) {
  SteppedSweep::Settings settings = sweep(1.20, 1.40, 5);
  settings.directions = SteppedSweep::Directions::independent;
  const SteppedSweep analysis(settings);
  ASSERT_EQ(analysis.lines(), 5u);
  testing::Points points;
  for (const std::size_t line : {4u, 2u, 0u, 3u, 1u}) {
    System system = isolator(1);
    analysis.run_line(line, system, points);
  }
  SteppedSweep::Settings one = sweep(1.30, 1.40, 2);
  one.parameter.values.front() = settings.parameter.values[2];
  one.directions = SteppedSweep::Directions::forward;
  System system = isolator(1);
  testing::Points alone;
  SteppedSweep(one).run_line(0, system, alone);
  EXPECT_EQ(peak(points, {2, 0}), peak(alone, {0, 0}));
}

// The force amplitude is swept by building the system anew; where the response is unique this is
// the same as each amplitude alone.
TEST(SteppedSweepTest, AnyParameterIsSwept) {
  SteppedSweep::Settings settings = sweep(1.0, 1.0, 2);
  settings.parameter = {.path = "Excitation/push/Frequency", .unit = "rad/s", .values = {0.9, 1.1}};
  testing::Points points([](const std::vector<parameters::Override> &overrides) {
    return isolator(std::stod(overrides.at(0).value));
  });
  System system = isolator(0.9);
  SteppedSweep(settings).run_line(0, system, points);

  testing::Points direct;
  System swept = isolator(1);
  SteppedSweep(sweep(0.9, 1.1, 2)).run_line(0, swept, direct);
  for (const std::size_t point : {0u, 1u})
    for (const std::size_t direction : {0u, 1u})
      EXPECT_NEAR(peak(points, {point, direction}), peak(direct, {point, direction}), 1e-6);
}

TEST(SteppedSweepTest, AParameterThatChangesTheStateFails) {
  SteppedSweep::Settings settings = sweep(1.0, 1.0, 2);
  settings.parameter = {.path = "Body/mass/Modes/Number", .unit = "1", .values = {1, 2}};
  testing::Points points([](const std::vector<parameters::Override> &overrides) {
    System system = isolator(1);
    if (overrides.at(0).value == "2")
      system.contacts = {},
      system.model =
          Model({testing::single_mass("a", 1, 1, 0), testing::single_mass("b", 1, 1, 0)});
    return system;
  });
  System system = isolator(1);
  SteppedSweep(settings).run_line(0, system, points);
  EXPECT_EQ(points.all().at({0, 0}).status, Status::finished);
  EXPECT_EQ(points.all().at({1, 0}).status, Status::failed);
}

// The last point of the forward sweep, beyond the fold, fails, and the backward sweep begins there:
// the jump in between was in no direction of it.
TEST(SteppedSweepTest, AfterAFailureAtTheTurnNoJumpIsSought) {
  SteppedSweep::Settings settings = sweep(1.0, 1.0, 2);
  settings.parameter = {
      .path = "Excitation/push/Frequency", .unit = "rad/s", .values = {1.2, 1.28, 1.36, 1.4}};
  settings.jump_tolerance = 1e-3;
  settings.settling.maximum = 200;
  bool failed = false;
  testing::Points points([&](const std::vector<parameters::Override> &overrides) {
    const double lambda = std::stod(overrides.at(0).value);
    if (lambda > 1.39 && !std::exchange(failed, true))
      throw NumericalError("once");
    return isolator(lambda);
  });
  System system = isolator(1.2);
  SteppedSweep(settings).run_line(0, system, points);
  EXPECT_EQ(points.all().at({3, 0}).status, Status::failed);
  EXPECT_EQ(points.all().at({3, 1}).status, Status::finished);
  EXPECT_LT(peak(points, {3, 1}), 0.7 * peak(points, {2, 0})); // on the other side of the fold
  EXPECT_TRUE(std::isnan(points.value({3, 1}, "jump_from")));
}

// What an earlier run finished is taken over: the rest comes out the same to the last bit.
TEST(SteppedSweepTest, AResumedSweepWithRefinementIsTheSame) {
  SteppedSweep::Settings settings = sweep(1.34, 1.40, 4);
  settings.jump_tolerance = 1e-3;
  settings.directions = SteppedSweep::Directions::forward;
  settings.settling.maximum = 100;
  const SteppedSweep analysis(settings);
  testing::Points whole;
  System system = isolator(1);
  analysis.run_line(0, system, whole);
  for (std::size_t known = 1; known < 4; ++known) {
    testing::Points rest;
    for (std::size_t i = 0; i < known; ++i)
      rest.know(whole.all().at({i, 0}));
    System again = isolator(1);
    analysis.run_line(0, again, rest);
    ASSERT_EQ(rest.all().size(), 4 - known);
    for (const auto &[index, result] : rest.all())
      for (const Field &field : result.fields)
        for (std::size_t i = 0; i < field.values.size(); ++i)
          EXPECT_TRUE(field.values[i] == whole.values(index, field.name())[i] ||
                      std::isnan(field.values[i]))
              << field.name();
  }
}

} // namespace stepped_sweep_tests
} // namespace vibroimpact::analyses
