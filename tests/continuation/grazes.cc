#include "piecewise.h"

#include "common/decompositions.h"
#include "continuation/branch.h"

#include <gtest/gtest.h>

namespace vibroimpact::continuation {
namespace grazes_tests {

Settings within(double lower, double upper) {
  Settings settings;
  settings.first_key = {lower, upper};
  return settings;
}

Start open_start(double a, double p) { return {{vector({p / (1 - a)}), vector({p})}, {}, true}; }

// Fixed points p / (1 - a) while p < 0 and p / (1 - a - c) behind: they go on where both divisors
// have one sign.
TEST(GrazesTest, AreCrossedAtACornerThatGoesOn) {
  for (const bool tells_jump : {true, false})
    for (const double c : {-1.0, -2.5, -1e4}) {
      const double a = 0.5;
      PiecewiseMap map = scalar_map(a, c, Touch::corner);
      map.tells_jump = tells_jump;
      const Branch branch = follow(map, open_start(a, -0.5), within(-1, 1));
      EXPECT_EQ(branch.end, End::upper_bound) << branch.reason << " at " << c;
      EXPECT_NEAR(branch.points.back().point.state(0), 1 / (1 - a - c), 1e-14);
      ASSERT_EQ(branch.special.size(), 1u) << c;
      const SpecialPoint &graze = branch.special[0];
      EXPECT_EQ(graze.kind, Special::graze);
      ASSERT_TRUE(graze.graze);
      EXPECT_EQ(graze.graze->name, "the stop");
      EXPECT_NEAR(graze.at.point.state(0), 0, 1e-15);
      EXPECT_NEAR(graze.at.point.keys(0), 0, 1e-15);
      EXPECT_EQ(graze.unstable_before, 0);
      EXPECT_EQ(graze.unstable_after, a + c < -1 ? 1 : 0);
    }
}

// Where they have opposite signs the branch turns back: both fixed points are at p < 0.
TEST(GrazesTest, AreFoldsAtACornerThatTurns) {
  for (const double c : {1.0, 1e3}) {
    const double a = 0.5;
    PiecewiseMap map = scalar_map(a, c, Touch::corner);
    const Branch branch = follow(map, open_start(a, -0.5), within(-1, 1));
    EXPECT_EQ(branch.end, End::lower_bound) << branch.reason;
    EXPECT_NEAR(branch.points.back().point.state(0), -1 / (1 - a - c), 1e-13);
    ASSERT_EQ(branch.special.size(), 1u);
    EXPECT_EQ(branch.special[0].kind, Special::grazing_fold);
    EXPECT_NEAR(branch.special[0].at.point.keys(0), 0, 1e-15);
    EXPECT_EQ(branch.special[0].unstable_before, 0);
    EXPECT_EQ(branch.special[0].unstable_after, 1);
  }
}

TEST(GrazesTest, AreCrossedWhereContactIsLost) {
  for (const double c : {-1e4, -1.0, 1.0}) {
    const double a = 0.5, p = c < 0 ? 0.5 : -0.5;
    PiecewiseMap map = scalar_map(a, c, Touch::corner);
    const Start start{{vector({p / (1 - a - c)}), vector({p})}, {}, c > 0};
    const Branch branch = follow(map, start, within(-1, 1));
    EXPECT_EQ(branch.end, End::lower_bound) << branch.reason;
    EXPECT_NEAR(branch.points.back().point.state(0), -1 / (1 - a), 1e-13);
    ASSERT_EQ(branch.special.size(), 1u);
    EXPECT_EQ(branch.special[0].kind, c < 0 ? Special::graze : Special::grazing_fold);
  }
}

// With y = sqrt x: (1 - a) y^2 + s y = p. For s > 0 the branch goes on, at first with a multiplier
// of -infinity; a - s / (2 y) = -1 at y = s / (2 (1 + a)).
TEST(GrazesTest, AreCrossedAtSquareRootsWithTheFlipBehind) {
  for (const double s : {0.3, 0.01}) {
    const double a = 0.4, y = s / (2 * (1 + a)), last = std::sqrt(1.0);
    PiecewiseMap map = scalar_map(a, -s, Touch::square_root);
    const Branch branch = follow(map, open_start(a, -0.5), within(-1, (1 - a) * last + s * last));
    EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
    EXPECT_NEAR(branch.points.back().point.state(0), 1, 1e-13);
    ASSERT_EQ(branch.special.size(), 2u);
    EXPECT_EQ(branch.special[0].kind, Special::graze);
    EXPECT_EQ(branch.special[0].unstable_before, 0);
    EXPECT_EQ(branch.special[0].unstable_after, 1);
    EXPECT_EQ(branch.special[1].kind, Special::flip);
    EXPECT_NEAR(branch.special[1].at.point.keys(0), (1 - a) * y * y + s * y, 1e-14);
  }
}

// For s < 0 it turns at the graze, and again where y = |s| / (2 (1 - a)).
TEST(GrazesTest, AreFoldsAtSquareRootsWithTheFoldBehind) {
  for (const double s : {-0.3, -0.01}) {
    const double a = 0.4;
    PiecewiseMap map = scalar_map(a, -s, Touch::square_root);
    const Branch branch = follow(map, open_start(a, -0.5), within(-1, 1));
    EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
    ASSERT_EQ(branch.special.size(), 2u);
    EXPECT_EQ(branch.special[0].kind, Special::grazing_fold);
    EXPECT_NEAR(branch.special[0].at.point.keys(0), 0, 1e-15);
    EXPECT_EQ(branch.special[1].kind, Special::fold);
    EXPECT_NEAR(branch.special[1].at.point.keys(0), -s * s / (4 * (1 - a)), 1e-15);
  }
}

// The end of the key just behind the graze is not stepped over.
TEST(GrazesTest, AreCrossedCloseToTheEndOfTheKey) {
  const double a = 0.4, s = 0.3;
  for (const double last : {1e-1, 1e-2, 1e-4}) {
    PiecewiseMap map = scalar_map(a, -s, Touch::square_root);
    const Branch branch = follow(map, open_start(a, -0.5), within(-1, last));
    EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
    EXPECT_EQ(branch.points.back().point.keys(0), last);
    const double y = std::sqrt(branch.points.back().point.state(0));
    // An error of 1e-11 in x is one of s 1e-11 / (2 y) in p.
    EXPECT_NEAR((1 - a) * y * y + s * y, last, 1e-11 * (1 + s / y));
    for (const BranchPoint &point : branch.points)
      EXPECT_LE(point.point.keys(0), last);
  }
}

// Arclengths of points and special points grow along the branch, also where it turns.
TEST(GrazesTest, LieBetweenTheirNeighbours) {
  for (const double s : {-0.3, -0.01, 0.3}) {
    PiecewiseMap map = scalar_map(0.4, -s, Touch::square_root);
    const Branch branch = follow(map, open_start(0.4, -0.5), within(-1, 1));
    double last = 0;
    for (const SpecialPoint &special : branch.special) {
      EXPECT_GE(special.at.arclength, last);
      EXPECT_GE(special.at.arclength, branch.points[special.after].arclength);
      EXPECT_LE(special.at.arclength, branch.points[special.after + 1].arclength);
      last = special.at.arclength;
    }
  }
}

// The multiplier a - 3/2 k sqrt x is continuous, but -1 at x = (2 (1 + a) / (3 k))^2 already: a
// flip, no jump of stability.
TEST(GrazesTest, HaveTrueFlipsCloseBehindWhereTheForceIsContinuous) {
  for (const double k : {10.0, 1e3, 1e5}) {
    const double a = 0.2, root = 2 * (1 + a) / (3 * k), x = root * root;
    PiecewiseMap map = scalar_map(a, -k, Touch::smooth);
    const Branch branch = follow(map, open_start(a, -0.5), within(-1, 1));
    EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
    ASSERT_EQ(branch.special.size(), 2u) << k;
    EXPECT_EQ(branch.special[0].kind, Special::graze);
    EXPECT_EQ(branch.special[0].unstable_before, branch.special[0].unstable_after);
    EXPECT_EQ(branch.special[1].kind, Special::flip);
    const double expected = (1 - a) * x + k * root * x;
    EXPECT_NEAR(branch.special[1].at.point.keys(0), expected, 1e-12 * expected + 1e-16) << k;
  }
}

// Two coordinates, a guard of both and of the key; the affine systems of both sides say where the
// branch ends.
TEST(GrazesTest, OfSeveralCoordinates) {
  PiecewiseMap map;
  map.by_state.resize(2, 2);
  map.by_state << 0.5, 0.3, -0.4, 0.6;
  map.by_keys = vector({0.7, -0.2});
  map.guard_by_state = vector({-1, 0.4}).transpose();
  map.guard_by_keys = RowVector::Constant(1, -0.3);
  map.guard_constant = 0.25;
  map.touch = Touch::corner;
  for (const double stiffness : {0.5, 200.0}) {
    map.impulse = stiffness * vector({-1, 0.2});
    const Matrix open = Matrix::Identity(2, 2) - map.by_state;
    const Matrix closed = open + map.impulse * map.guard_by_state;
    const Vector open_slope = inverse(open) * map.by_keys;
    const double p =
        -map.guard_constant / (map.guard_by_state.dot(open_slope) + map.guard_by_keys(0));
    const auto on_contact = [&](double key) {
      return Vector(
          inverse(closed) *
          (map.by_keys * key - map.impulse * (map.guard_by_keys(0) * key + map.guard_constant)));
    };
    const double beyond =
        on_contact(2).dot(map.guard_by_state) + 2 * map.guard_by_keys(0) + map.guard_constant < 0
            ? 2
            : -2;
    const Branch branch =
        follow(map, {{Vector(open_slope * -1), vector({-1})}, {}, true}, within(-2, 2));
    ASSERT_EQ(branch.special.size(), 1u) << branch.reason;
    EXPECT_NEAR(branch.special[0].at.point.keys(0), p, 1e-14);
    EXPECT_LT((branch.special[0].at.point.state - open_slope * p).norm(), 1e-14);
    EXPECT_EQ(branch.points.back().point.keys(0), beyond) << branch.reason;
    EXPECT_LT((branch.points.back().point.state - on_contact(beyond)).norm(), 1e-13);
  }
}

// The same with a square root: at a given depth d = y^2 the system is linear for state and key, so
// that both are polynomials of y.
TEST(GrazesTest, OfSeveralCoordinatesAtSquareRoots) {
  PiecewiseMap map;
  map.by_state.resize(2, 2);
  map.by_state << 0.5, 0.3, -0.4, 0.6;
  map.by_keys = vector({0.7, -0.2});
  map.guard_by_state = vector({-1, 0.4}).transpose();
  map.guard_by_keys = RowVector::Constant(1, -0.3);
  map.guard_constant = 0.25;
  map.touch = Touch::square_root;
  const Matrix open = Matrix::Identity(2, 2) - map.by_state;
  Matrix system(3, 3);
  system << open, -map.by_keys, map.guard_by_state, map.guard_by_keys;
  for (const double strength : {-0.4, 0.02, 0.4}) {
    map.impulse = strength * vector({-1, 0.2});
    const auto behind = [&](double y) {
      Vector right(3);
      right << map.impulse * y, -map.guard_constant - y * y;
      return Vector(inverse(system) * right);
    };
    const Vector start = inverse(open) * map.by_keys * -1;
    const Branch branch = follow(map, {{start, vector({-1})}, {}, true}, within(-2, 2));
    EXPECT_TRUE(branch.end == End::lower_bound || branch.end == End::upper_bound) << branch.reason;
    ASSERT_FALSE(branch.special.empty());
    EXPECT_NEAR(branch.special[0].at.point.keys(0), behind(0)(2), 1e-14);
    int touching = 0;
    for (const BranchPoint &point : branch.points) {
      const double depth = -map.guard(point.point);
      if (depth <= 0)
        continue;
      const Vector expected = behind(std::sqrt(depth));
      EXPECT_LT((point.point.state - expected.head(2)).norm(), 1e-11);
      EXPECT_NEAR(point.point.keys(0), expected(2), 1e-11);
      ++touching;
    }
    EXPECT_GT(touching, 5) << strength;
  }
}

// Two coordinates x -> p - p_i + 0.5 x - 0.1 max(0, x), whose stops are touched at p_i close to
// each other.
TEST(GrazesTest, OfTwoGuardsWithinAStep) {
  class TwoStops : public Problem {
  public:
    Vector scales() const override { return vector({1, 1, 1}); }
    Evaluation evaluate(const Point &at) override {
      Evaluation result = extend(at, {}).smooth;
      for (Index i = 0; i < 2; ++i) {
        result.pattern.push_back(at.state(i) > 0);
        result.residual(i) -= 0.1 * std::max(0.0, at.state(i));
        result.by_state(i, i) -= at.state(i) > 0 ? 0.1 : 0;
      }
      return result;
    }
    std::vector<Graze> grazes_near(const Point &at) override {
      std::vector<Graze> near;
      for (Index i = 0; i < 2; ++i)
        if (std::abs(at.state(i)) < sight)
          near.push_back({.guard = static_cast<int>(i), .name = i == 0 ? "first" : "second"});
      return near;
    }
    Extension extend(const Point &at, const Graze &graze) override {
      Extension result;
      const Vector touched = vector({0, 3e-3});
      result.smooth = {-0.5 * at.state + Vector::Constant(2, at.keys(0)) - touched,
                       -0.5 * Matrix::Identity(2, 2),
                       Vector::Ones(2),
                       {}};
      const Index other = 1 - graze.guard;
      const bool contact = at.state(other) > 0; // the other stop acts as it does
      result.smooth.residual(other) -= 0.1 * std::max(0.0, at.state(other));
      result.smooth.by_state(other, other) -= contact ? 0.1 : 0;
      result.value = -at.state(graze.guard);
      result.by_state = -Vector::Unit(2, graze.guard).transpose();
      result.by_keys = RowVector::Zero(1);
      result.touch = Touch::corner;
      result.jump = 0.1 * Vector::Unit(2, graze.guard);
      return result;
    }
    double sight = 10; ///< how near a guard is to be seen
  } problem;
  for (const double step : {0.1, 0.03})
    for (const double sight : {10.0, 0.05, 4e-3, 1e-3, 1e-5}) {
      Settings settings = within(-1, 1);
      settings.longest_step = step;
      problem.sight = sight;
      const Branch branch =
          follow(problem, {{vector({-0.8, -0.806}), vector({-0.4})}, {}, true}, settings);
      EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
      ASSERT_EQ(branch.special.size(), 2u) << sight;
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(branch.special[i].kind, Special::graze) << sight;
        EXPECT_EQ(branch.special[i].graze->name, i == 0 ? "first" : "second");
        EXPECT_NEAR(branch.special[i].at.point.keys(0), i == 0 ? 0 : 3e-3, 1e-14);
        EXPECT_EQ(branch.special[i].width, 0);
      }
    }
}

// A guard that touches zero without any change of pattern, just before the end of the values.
TEST(GrazesTest, AreNotCrossedWhereThePatternStays) {
  class Unconcerned : public Algebraic {
  public:
    Unconcerned()
        : Algebraic(
              [](const Point &at) {
                if (at.keys(0) > 0.5)
                  throw NumericalError("nothing beyond a half");
                return scalar(at.state(0) - at.keys(0), 1, -1);
              },
              vector({1, 1})) {}
    std::vector<Graze> grazes_near(const Point &) override { return {Graze{.name = "a stop"}}; }
    Extension extend(const Point &at, const Graze &) override {
      Extension result;
      result.smooth = scalar(at.state(0) - at.keys(0), 1, -1);
      result.value = 0.4999 - at.keys(0);
      result.by_state = RowVector::Zero(1);
      result.by_keys = RowVector::Constant(1, -1);
      return result;
    }
  } problem;
  const Branch branch = follow(problem, {{vector({0}), vector({0})}, {}, true}, Settings());
  EXPECT_EQ(branch.end, End::least_step) << branch.reason;
  EXPECT_TRUE(branch.special.empty());
  EXPECT_NEAR(branch.points.back().point.keys(0), 0.5, 4e-9);
}

// Without an extension the change is enclosed and reported, and a sign of a test that jumps is no
// flip.
TEST(GrazesTest, AreChangesOfPatternWhereNoExtensionIsOffered) {
  const double a = 0.5, c = -1.7;
  PiecewiseMap map = scalar_map(a, c, Touch::corner);
  map.offers_extension = false;
  Settings settings = within(-1, 1);
  settings.largest_angle = 2;
  settings.largest_correction = 10;
  const Branch branch = follow(map, open_start(a, -0.5), settings);
  EXPECT_EQ(branch.end, End::upper_bound) << branch.reason;
  ASSERT_EQ(branch.special.size(), 1u);
  EXPECT_EQ(branch.special[0].kind, Special::pattern_change);
  EXPECT_LT(branch.special[0].width, 1e-8);
  const double key = branch.special[0].at.point.keys(0);
  EXPECT_TRUE(key > 0 && key - branch.special[0].width <= 0) << key;
  EXPECT_EQ(branch.special[0].unstable_before, 0);
  EXPECT_EQ(branch.special[0].unstable_after, 1);
}

} // namespace grazes_tests
} // namespace vibroimpact::continuation
