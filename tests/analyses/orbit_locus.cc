// Loci of special points in two keys as an analysis: the cusp of the isolator's folds, and its
// first touches in closed form.
#include "analyses/curves/orbit_locus.h"

#include "analyses/curves/locus_follower.h"
#include "support/isolator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace orbit_locus_tests {

using testing::field_of;
using testing::isolator_system;
using testing::IsolatorPoint;

constexpr double pi = std::numbers::pi;

SweptParameter key(const std::string &path, double first, double last) {
  return {.path = path, .unit = "1", .values = {first, last}};
}
SweptParameter frequency(double first, double last) {
  return {.path = {}, .values = {first / (2 * pi), last / (2 * pi)}};
}

PointResult run(const SweptParameter &first, const SweptParameter &second,
                const std::vector<double> &at, LocusOf kind, double lambda,
                const std::vector<double> &state, int most_points = 1000) {
  OrbitLocus::Settings settings{.keys = {first, second},
                                .start_values = at,
                                .kinds = {kind},
                                .start = {.state = state},
                                .excitation = {}};
  settings.continuation.first_key = {.lower = first.values[0], .upper = first.values[1]};
  settings.continuation.second_key = {.lower = second.values[0], .upper = second.values[1]};
  settings.continuation.most_points = most_points;
  IsolatorPoint point(lambda);
  System system = isolator_system(lambda, 2, 0.52);
  OrbitLocus(settings).run_line(0, system, point);
  return point.result;
}

void expect_cusp(const PointResult &result) {
  ASSERT_EQ(result.status, Status::finished) << result.reason;
  ASSERT_EQ(field_of(result, "special/kind").values, std::vector<double>{1});
  EXPECT_NEAR(2 * pi * field_of(result, "special/frequency").values[0], 1.220670223706, 1e-9);
  EXPECT_NEAR(field_of(result, "special/mu").values[0], 0.782854460508, 1e-9);
}

// One locus has both folds, so that it is followed once.
TEST(OrbitLocusTest, CuspOfTheIsolator) {
  const PointResult result =
      run(frequency(0.5, 2), key("mu", 0.5, 3), {0, 2}, LocusOf::fold, 1.3, {0, -1});
  expect_cusp(result);
  EXPECT_EQ(field_of(result, "end/reason").values, (std::vector<double>{0, 0}));
  EXPECT_EQ(field_of(result, "end/locus").values, (std::vector<double>{0, 0}));
  EXPECT_EQ(field_of(result, "end/mu").values, (std::vector<double>{3, 3}));
}

// From each of the two branches of folds: along the stiffness one meets only one of them.
TEST(OrbitLocusTest, CuspFromEitherFold) {
  for (const double lambda : {1.3, 1.231})
    expect_cusp(
        run(key("mu", 0.5, 3), frequency(0.5, 2), {2.5, 0}, LocusOf::fold, lambda, {-1.9, 1}));
}

TEST(OrbitLocusTest, LociThatEndEarlySayWhere) {
  const PointResult result =
      run(frequency(0.3, 1.8), key("f", 0.05, 1.2), {0, 0.52}, LocusOf::graze, 0.5, {0, 0}, 12);
  EXPECT_EQ(result.status, Status::finished);
  EXPECT_NE(result.reason.find("a locus ends at frequency = "), std::string::npos);
  EXPECT_NE(result.reason.find("Hz, f = "), std::string::npos);
  EXPECT_NE(result.reason.find("the limit of 12 points"), std::string::npos) << result.reason;
}

// |x| = 1 without contact: f = |1 - l^2 + 0.02 i l|.
TEST(OrbitLocusTest, FirstTouchesInClosedForm) {
  const PointResult result =
      run(frequency(0.3, 1.8), key("f", 0.05, 1.2), {0, 0.52}, LocusOf::graze, 0.5, {0, 0});
  ASSERT_EQ(result.status, Status::finished) << result.reason;
  const std::vector<double> &w = field_of(result, "frequency").values;
  EXPECT_GT(w.size(), 20u);
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double l = 2 * pi * w[i];
    EXPECT_NEAR(field_of(result, "f").values[i], std::hypot(1 - l * l, 0.02 * l), 1e-12) << l;
  }
  EXPECT_NEAR(2 * pi * *std::max_element(w.begin(), w.end()), 1.4829, 1e-3); // f = 1.2
}

TEST(OrbitLocusTest, NothingOfTheKindIsAFailedPoint) {
  const PointResult result =
      run(frequency(0.5, 2), key("mu", 0.5, 3), {0, 2}, LocusOf::neimark_sacker, 1.3, {0, -1});
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_NE(result.reason.find("no special point"), std::string::npos) << result.reason;
}

// A multiplier -1 of half a symmetric motion is no period doubling: its branch loses the symmetry.
TEST(OrbitLocusTest, FlipsOfHalfAMotionAreLossesOfSymmetry) {
  for (const long halves : {1, 2, 3})
    for (const LocusOf wanted : {LocusOf::period_doubling, LocusOf::loss_of_symmetry}) {
      LocusOrigins origins({wanted});
      origins.begin(0, halves, 1);
      continuation::SpecialPoint flip;
      flip.kind = continuation::Special::flip;
      flip.at.point.keys = Vector::Constant(1, 0.3);
      origins.add(flip);
      const bool symmetric = halves % 2 != 0;
      EXPECT_EQ(origins.in_order().size(),
                symmetric == (wanted == LocusOf::loss_of_symmetry) ? 1u : 0u)
          << halves;
    }
}

} // namespace orbit_locus_tests
} // namespace vibroimpact::analyses
