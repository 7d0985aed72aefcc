// Harmonic balance as an analysis: folds of the isolator over the frequency and over another key,
// the linear part in closed form, and motions that a guess finds.
#include "analyses/curves/balance_branch.h"

#include "support/isolator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace balance_branch_tests {

using testing::field_of;
using testing::isolator_system;
using testing::IsolatorPoint;

constexpr double pi = std::numbers::pi;
constexpr const char *peak = "point/block.head/displacement_x/largest";

BalanceBranch::Settings along_frequency(Index harmonics) {
  BalanceBranch::Settings settings{
      .parameter = {.path = {}, .values = {0.6 / (2 * pi), 2 / (2 * pi)}},
      .harmonics = harmonics,
      .guess = {},
      .excitation = {}};
  settings.continuation.first_key = {.lower = settings.parameter.values[0],
                                     .upper = settings.parameter.values[1]};
  settings.continuation.longest_step = 0.05;
  return settings;
}

PointResult run(const BalanceBranch::Settings &settings, double lambda, double mu) {
  IsolatorPoint point(lambda);
  System system = isolator_system(lambda, mu);
  const BalanceBranch analysis(settings);
  analysis.check(system);
  analysis.run_line(0, system, point);
  EXPECT_EQ(point.result.status, Status::finished) << point.result.reason;
  return point.result;
}

TEST(BalanceBranchTest, FoldsOfAveragingFromAnyStart) {
  for (const double lambda : {1.3, 1.9}) {
    const PointResult result = run(along_frequency(1), lambda, 2);
    EXPECT_EQ(field_of(result, "special/kind").values, (std::vector<double>{1, 1}));
    std::vector<double> folds = field_of(result, "special/frequency").values;
    std::sort(folds.begin(), folds.end());
    EXPECT_NEAR(2 * pi * folds[0], 1.231127, 6e-7);
    EXPECT_NEAR(2 * pi * folds[1], 1.371611, 6e-7);
    EXPECT_EQ(field_of(result, "end/reason").values, (std::vector<double>{0, 1}));
    const std::vector<double> &along = field_of(result, "arclength").values;
    EXPECT_TRUE(std::is_sorted(along.begin(), along.end()));
    EXPECT_EQ(std::count(along.begin(), along.end(), 0.0), 1);
  }
}

// Where the stops are out of reach one harmonic is everything.
TEST(BalanceBranchTest, MotionsWithoutContactInClosedForm) {
  const PointResult result = run(along_frequency(3), 1.9, 2);
  const std::vector<double> &frequency = field_of(result, "frequency").values;
  int free = 0;
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const double w = 2 * pi * frequency[i];
    const double expected = 0.52 / std::hypot(1 - w * w, 0.02 * w);
    if (field_of(result, peak).values[i] >= 1)
      continue;
    ++free;
    EXPECT_NEAR(field_of(result, peak).values[i], expected, 1e-12);
    EXPECT_NEAR(
        field_of(result, "point/block.head/displacement_x/harmonic_amplitude").values[4 * i + 1],
        expected, 1e-12);
    EXPECT_EQ(field_of(result, "force_left_out").values[i], 0);
    EXPECT_EQ(field_of(result, "contact/right/normal_force/maximum").values[i], 0);
    EXPECT_NEAR(field_of(result, "contact/left/gap/minimum").values[i], 1 - expected, 1e-12);
  }
  EXPECT_GT(free, 10);
}

// The upper fold for mu = 2 is at this frequency, so that over mu it is at 2.
TEST(BalanceBranchTest, FoldAlongAnotherKey) {
  const PointResult over_frequency = run(along_frequency(5), 1.3, 2);
  const std::vector<double> &folds = field_of(over_frequency, "special/frequency").values;
  const double lambda = 2 * pi * *std::max_element(folds.begin(), folds.end());
  BalanceBranch::Settings settings = along_frequency(5);
  settings.parameter = {.path = "Contact/right/Stiffness", .unit = "1", .values = {1, 4}};
  settings.continuation.first_key = {.lower = 1, .upper = 4};
  settings.start_value = 2.5;
  settings.guess = {0, -1.9, 0.6}; // the large motion
  const PointResult result = run(settings, lambda, 2.5);
  const std::vector<double> &found = field_of(result, "special/Contact.right.Stiffness").values;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0], 2, 1e-9);
}

TEST(BalanceBranchTest, OneDirection) {
  BalanceBranch::Settings settings = along_frequency(1);
  settings.directions = Directions::backward;
  const PointResult back = run(settings, 1.9, 0.5);
  EXPECT_NEAR(2 * pi * field_of(back, "frequency").values.back(), 1.9, 1e-12);
  EXPECT_EQ(field_of(back, "end/reason").values, std::vector<double>{0});
  settings.directions = Directions::forward;
  const PointResult ahead = run(settings, 1.9, 0.5);
  EXPECT_NEAR(2 * pi * field_of(ahead, "frequency").values.front(), 1.9, 1e-12);
  EXPECT_EQ(field_of(ahead, "end/reason").values, std::vector<double>{1});
}

// What is left out is larger than what the largest displacement misses, since it is largest where
// the stop is reached; the force jumps there, so that it falls like H^-2.
TEST(BalanceBranchTest, EstimateOfTheError) {
  const auto start = [](const PointResult &result, const std::string &field) {
    const std::vector<double> &along = field_of(result, "arclength").values;
    const auto at = std::find(along.begin(), along.end(), 0.0) - along.begin();
    return field_of(result, field).values[static_cast<std::size_t>(at)];
  };
  std::vector<double> peaks, estimates;
  for (const Index harmonics : {3, 9, 45}) {
    BalanceBranch::Settings settings = along_frequency(harmonics);
    settings.guess = {0, -1.9, 0.6};
    settings.continuation.most_points = 2;
    const PointResult result = run(settings, 1.2, 2);
    peaks.push_back(start(result, peak));
    estimates.push_back(start(result, "point/block.head/displacement_x/left_out"));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const double error = std::abs(peaks[i] - peaks[2]);
    EXPECT_LT(error, estimates[i]) << i;
  }
  EXPECT_LT(estimates[1], estimates[0] / 3);
}

TEST(BalanceBranchTest, AnotherSourceMustFitAtBothEndsOfTheFrequency) {
  System system = isolator_system(1.3, 2);
  system.model.add_force("hum",
                         std::make_shared<model::Harmonic>(model::Given::displacement, 0.1, 2.6, 0),
                         {}, Vector3::UnitX());
  BalanceBranch::Settings settings = along_frequency(3);
  settings.excitation = "push";
  EXPECT_THROW(BalanceBranch(settings).check(system), InputError);
  settings.parameter = {.path = "Contact/right/Stiffness", .unit = "1", .values = {1, 4}};
  settings.start_value = 2;
  EXPECT_NO_THROW(BalanceBranch(settings).check(system));
}

} // namespace balance_branch_tests
} // namespace vibroimpact::analyses
