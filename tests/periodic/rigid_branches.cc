// Branches through the graze of a rigid stop, against the motion with one impact in closed form.
//
// x'' + c x' + x = A cos(w t + phi) with a stop at 1 and restitution e. Between impacts x = h + p
// with the periodic answer p to the force and a free vibration h. With the impact speed v at time
// zero,
//
//     h(T) - h(0) = 0,   h'(T) - h'(0) = (1 + e) v,   h(0) + p = 1,   h'(0) + p' = -e v
//
// so that h, p and p' at the impact are affine in v, and A^2 = |Z(w)|^2 (p^2 + (p'/w)^2) is a
// parabola in v, Z = 1 - w^2 + i c w: its vertex is the fold. With the flow E over a period and the
// impact's
//
//     S = [-e, 0; (1 + e) (F - 1) / v, -e]
//
// where F is the force at the impact, det(E S + 1) = 0 is a linear equation for v: the flip.
#include "continuation/branch.h"

#include "common/decompositions.h"
#include "family.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace rigid_branches_tests {

using continuation::Branch;
using continuation::Special;
using continuation::SpecialPoint;
using testing::Family;
using testing::Oscillator;

constexpr double damping = 0.1, restitution = 0.8;

class OneImpact {
public:
  explicit OneImpact(double w) : w_(w) {
    Matrix rate(2, 2);
    rate << 0, 1, -1, -damping;
    flow_ = exponential(rate * (2 * std::numbers::pi / w));
    const Vector h =
        solve_fully_pivoted(flow_ - Matrix::Identity(2, 2), Eigen::Vector2d(0, 1 + restitution));
    p_ = -h[0];
    rate_ = -restitution - h[1];
  }

  double amplitude(double v) const {
    return std::hypot(1 - w_ * w_, damping * w_) * std::hypot(1 + p_ * v, rate_ * v / w_);
  }
  double fold() const { return -p_ / (p_ * p_ + rate_ * rate_ / (w_ * w_)); }
  double trace(double v) const {
    return -restitution * flow_.trace() + into() * (force() - w_ * w_ / v);
  }
  double flip() const {
    const double e = restitution;
    return into() * w_ * w_ /
           (1 + e * e * determinant(flow_) - e * flow_.trace() + into() * force());
  }

private:
  double force() const { return (1 - w_ * w_) * p_ + damping * rate_; } // F - 1 = -w^2 + force v
  double into() const { return flow_(0, 1) * (1 + restitution); }

  double w_;
  Matrix flow_;
  double p_ = 0, rate_ = 0; ///< of p and p' at the impact, by v
};

Branch follow_through_graze(double w, double from, double lower, double upper) {
  Family family(
      [w](double a) {
        Oscillator model = testing::oscillator(1, 1, damping);
        model.push(a, w);
        model.stop({{1.0, testing::newton(restitution)}});
        return model;
      },
      false);
  const Orbit orbit = find_orbit(family.at(from), 1, Vector::Zero(2));
  OrbitProblem problem(family, 2,
                       problem_sizes(family.at(from), orbit, Vector::Constant(1, upper - lower)));
  continuation::Settings settings;
  settings.first_key = {.lower = lower, .upper = upper};
  settings.longest_step = 0.05;
  const continuation::Point start{
      .state = orbit.point.state, .keys = Vector::Constant(1, from), .chart = orbit.section.phase};
  return follow(problem, {.point = start, .direction = {}}, settings);
}

void expect_special(const SpecialPoint &found, Special kind, double key, double up_to, int before,
                    int after) {
  EXPECT_EQ(found.kind, kind) << name_of(found.kind);
  EXPECT_NEAR(found.at.point.keys[0], key, up_to);
  EXPECT_EQ(found.unstable_before, before);
  EXPECT_EQ(found.unstable_after, after);
}

/// A special point behind a graze, and what becomes of the stability there.
struct Behind {
  Special kind;
  double amplitude, up_to;
  Special graze; ///< what the graze is
};

void expect_graze_and(const Behind &behind, double w, double graze, double lower, double upper) {
  const Branch branch = follow_through_graze(w, 0.98 * graze, lower, upper);
  EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
  ASSERT_EQ(branch.special.size(), 2u) << w;
  expect_special(branch.special[0], behind.graze, graze, 1e-12, 0, 1);
  expect_special(branch.special[1], behind.kind, behind.amplitude, behind.up_to, 1, 0);
}

// The stop takes energy at once: the branch goes on to larger forces, unstable until the flip.
TEST(RigidBranchesTest, FlipBehindTheGraze) {
  for (const double w : {0.8, 2.0}) {
    const OneImpact exact(w);
    const double graze = exact.amplitude(0), flip = exact.amplitude(exact.flip());
    expect_graze_and({Special::flip, flip, 1e-11, Special::graze}, w, graze, 0.9 * graze,
                     flip + 0.5 * (flip - graze));
  }
}

// The branch turns at the graze and again at the fold.
TEST(RigidBranchesTest, FoldBehindTheGraze) {
  for (const double w : {0.5, 1.25}) {
    const OneImpact exact(w);
    const double graze = exact.amplitude(0), fold = exact.amplitude(exact.fold());
    expect_graze_and({Special::fold, fold, 1e-12, Special::grazing_fold}, w, graze, 0.2 * fold,
                     graze + 0.1 * (graze - fold));
  }
}

// The sum of the multipliers of all points behind the graze.
TEST(RigidBranchesTest, MotionsWithOneImpact) {
  const double w = 1.25;
  const OneImpact exact(w);
  const Branch branch = follow_through_graze(w, 0.5, 0.1, 0.6);
  int impacting = 0;
  for (const continuation::BranchPoint &point : branch.points) {
    if (point.pattern == branch.points.front().pattern)
      continue;
    const double a = point.point.keys[0];
    double low = point.unstable > 0 ? 0 : exact.fold(),
           high = point.unstable > 0 ? exact.fold() : 9 * low;
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      ((point.unstable > 0) == (exact.amplitude(middle) > a) ? low : high) = middle;
    }
    const std::complex<double> sum = point.multipliers[0] + point.multipliers[1];
    EXPECT_NEAR(sum.real() / exact.trace(low), 1, 1e-9) << a;
    ++impacting;
  }
  EXPECT_GT(impacting, 5);
}

} // namespace rigid_branches_tests
} // namespace vibroimpact::periodic
