// The limit of a sequence of states from a few of them: linear sequences have it in closed form.
#include "analyses/sequence_limit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::analyses {
namespace {

// x_n = limit + amplitude_1 first^n (cos n a, sin n a) + amplitude_2 second^n, mixed.
struct Sequence {
  Vector limit = Vector::LinSpaced(4, 1, 2);
  Matrix mixing = (Matrix(4, 3) << 1, 0.3, -0.2, 0, 1, 0.4, 2, -1, 1, 0.1, 0.1, 0.7).finished();
  double first = 0.6, angle = 0.9, second = -0.4, size = 1e-3;

  Vector operator()(int n) const {
    const Vector parts =
        Eigen::Vector3d(std::pow(first, n) * std::cos(angle * n),
                        std::pow(first, n) * std::sin(angle * n), std::pow(second, n));
    return limit + size * (mixing * parts);
  }
};

std::optional<Vector> limit_after(const Sequence &sequence, int states) {
  SequenceLimit of(Vector::Ones(4));
  for (int n = 0; n < states; ++n)
    of.add(sequence(n));
  return of.limit();
}

TEST(SequenceLimitTest, ThreeTermsNeedFiveStates) {
  const Sequence sequence;
  EXPECT_FALSE(limit_after(sequence, 2));
  const std::optional<Vector> limit = limit_after(sequence, 5);
  ASSERT_TRUE(limit);
  EXPECT_LE((*limit - sequence.limit).cwiseAbs().maxCoeff(), 1e-9 * sequence.size);
}

// In other units, which the scale makes up for, the same sequence has the same limit.
TEST(SequenceLimitTest, TheScaleStandsForUnits) {
  const Sequence sequence;
  const Vector units = (Vector(4) << 1e3, 1, 1e-6, 5).finished();
  SequenceLimit of(units.cwiseInverse());
  for (int n = 0; n < 5; ++n)
    of.add(sequence(n).cwiseProduct(units));
  const std::optional<Vector> limit = of.limit();
  ASSERT_TRUE(limit);
  EXPECT_LE((limit->cwiseQuotient(units) - sequence.limit).cwiseAbs().maxCoeff(),
            1e-9 * sequence.size);
}

// Two periods in turn, or a spiral outward, have their fixed point as the limit of the past.
TEST(SequenceLimitTest, UnstableFixedPointsAreNoLimits) {
  Sequence doubled;
  doubled.second = -1;
  EXPECT_FALSE(limit_after(doubled, 8));
  Sequence outward;
  outward.first = 1.02;
  EXPECT_FALSE(limit_after(outward, 8));
  Sequence slow;
  slow.second = 0.99;
  EXPECT_FALSE(limit_after(slow, 8));
}

TEST(SequenceLimitTest, FarLimitsAreNotBelieved) {
  Sequence wide;
  wide.size = 0.5;
  EXPECT_FALSE(limit_after(wide, 5));
}

TEST(SequenceLimitTest, ClearedItBeginsAnew) {
  const Sequence sequence;
  SequenceLimit of(Vector::Ones(4));
  of.add(Vector::Constant(4, 1e6));
  of.clear();
  for (int n = 0; n < 5; ++n)
    of.add(sequence(n));
  EXPECT_TRUE(of.limit());
  EXPECT_DOUBLE_EQ(of.last_change(), (sequence(4) - sequence(3)).cwiseAbs().maxCoeff());
}

TEST(SequenceLimitTest, ZerosOfPolynomialsInsideACircle) {
  // (z - 0.5)(z + 0.8) and (z^2 + 0.81)
  EXPECT_TRUE(zeros_within(Vector(Eigen::Vector2d(-0.4, 0.3)), 0.81));
  EXPECT_FALSE(zeros_within(Vector(Eigen::Vector2d(-0.4, 0.3)), 0.79));
  EXPECT_TRUE(zeros_within(Vector(Eigen::Vector2d(0.81, 0)), 0.91));
  EXPECT_FALSE(zeros_within(Vector(Eigen::Vector2d(0.81, 0)), 0.89));
  // (z - 2)(z - 0.1)(z + 0.1)
  EXPECT_FALSE(zeros_within(Vector(Eigen::Vector3d(0.02, -0.01, -2)), 1));
  EXPECT_TRUE(zeros_within(Vector(Eigen::Vector3d(0.02, -0.01, -2)), 2.01));
}

} // namespace
} // namespace vibroimpact::analyses
