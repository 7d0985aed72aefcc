#include "algebraic.h"

#include "continuation/locus.h"

#include <gtest/gtest.h>

namespace vibroimpact::continuation {
namespace loci_tests {

Settings within(Range first, Range second) {
  Settings settings;
  settings.first_key = first;
  settings.second_key = second;
  return settings;
}

// x^3 - b x - a = 0 with a second coordinate, in skew coordinates: folds at 27 a^2 = 4 b^3.
Evaluation cusp_normal_form(const Point &at) {
  Matrix skew(2, 2), slope(2, 2), by_keys(2, 2);
  skew << 1, 0.5, -0.3, 2;
  const Vector z = skew * at.state;
  const double x = z(0), y = z(1), a = at.keys(0), b = at.keys(1);
  slope << 3 * x * x - b, 0, 2 * x, -1;
  by_keys << -1, -x, 0, 1;
  Matrix mix(2, 2);
  mix << 2, 1, -1, 1;
  return {
      mix * vector({x * x * x - b * x - a, x * x + b - y}), mix * slope * skew, mix * by_keys, {}};
}

Point on_cusp_fold(double x) {
  Matrix skew(2, 2);
  skew << 1, 0.5, -0.3, 2;
  const double b = 3 * x * x, a = x * x * x - b * x;
  const double y = x * x + b, determinant = 2 + 0.15;
  return {vector({(2 * x - 0.5 * y) / determinant, (0.3 * x + y) / determinant}), vector({a, b})};
}

TEST(LociTest, OfFoldsPassTheirCusp) {
  Algebraic problem(cusp_normal_form, vector({1, 1, 1, 1}));
  for (const double start : {0.8, -0.83}) {
    const Locus locus = follow_locus(problem, {LocusKind::fold, on_cusp_fold(start), {}, false},
                                     within({-5, 5}, {-1, 3}));
    EXPECT_EQ(locus.end, End::bounds) << locus.reason;
    for (const LocusPoint &point : locus.points) {
      const double a = point.point.keys(0), b = point.point.keys(1);
      EXPECT_NEAR(27 * a * a, 4 * b * b * b, 1e-12);
      if (std::abs(a) > 1e-3) { // three solutions between the folds
        EXPECT_EQ(point.side, a > 0 ? -1 : 1) << a;
      }
    }
    EXPECT_DOUBLE_EQ(locus.points.back().point.keys(1), 3);
    EXPECT_NEAR(locus.points.back().point.keys(0), start > 0 ? 2 : -2, 1e-13);
    ASSERT_EQ(locus.special.size(), 1u);
    EXPECT_EQ(locus.special[0].kind, LocusSpecial::cusp);
    // Located in x to rounding over the step of its differences, 1e-11; the keys are of higher
    // order.
    EXPECT_LT(locus.special[0].at.point.state.norm(), 1e-10);
    EXPECT_LT(locus.special[0].at.point.keys.norm(), 1e-14);
  }
}

// A range that begins at the start, or by rounding behind it.
TEST(LociTest, BeginAtTheEndOfAKey) {
  Algebraic problem(cusp_normal_form, vector({1, 1, 1, 1}));
  const Point start = on_cusp_fold(0.8);
  for (const double rounding : {0.0, 1e-15, 1e-14})
    for (const bool forward : {true, false}) {
      const double lower = start.keys(1) + rounding;
      const Locus locus =
          follow_locus(problem, {LocusKind::fold, start, {}, forward}, within({-5, 5}, {lower, 3}));
      EXPECT_EQ(locus.end, End::bounds) << locus.reason;
      EXPECT_NEAR(locus.points.back().point.keys(1), forward ? 3 : lower, 1e-14) << locus.reason;
      EXPECT_EQ(locus.points.size() > 10, forward);
    }
}

TEST(LociTest, OfTheHenonMap) {
  PowerOfMap map(henon_map, vector({1, 1, 1, 1}));
  for (const LocusKind kind : {LocusKind::fold, LocusKind::flip}) {
    const double factor = kind == LocusKind::fold ? -0.25 : 0.75, b = 0.3, a = factor * 0.49;
    // At multipliers 1 and -1: 2 a x = -(1 - b) and 2 a x = 1 - b.
    const double x = (kind == LocusKind::fold ? -1 : 1) * (1 - b) / (2 * a);
    for (const bool forward : {true, false}) {
      const Locus locus =
          follow_locus(map, {kind, {vector({x, b * x}), vector({a, b})}, {}, forward},
                       within({-5, 5}, {-0.8, 0.8}));
      EXPECT_EQ(locus.end, End::bounds) << locus.reason;
      EXPECT_DOUBLE_EQ(locus.points.back().point.keys(1), forward ? 0.8 : -0.8);
      EXPECT_GT(locus.points.size(), 8u);
      EXPECT_TRUE(locus.special.empty());
      for (const LocusPoint &point : locus.points) {
        const double rest = 1 - point.point.keys(1);
        EXPECT_NEAR(point.point.keys(0), factor * rest * rest, 1e-13);
        EXPECT_EQ(point.side, 1); // fixed points, and then period 2, at larger a
      }
    }
  }
}

// (x, y) -> (a x (1 - y) + c x^2, x): x = (a - 1) / (a - c), det J = a x, tr J = 1 + c x. On the
// curve a x = 1: c = 2 a - a^2 and cos(arg mu) = (3 - a) / 2, which ends at a = 5 with both
// multipliers at -1.
PowerOfMap two_key_delayed_logistic() {
  return {[](const Vector &x, const Vector &keys) {
            const double a = keys(0), c = keys(1);
            Image image{vector({a * x(0) * (1 - x(1)) + c * x(0) * x(0), x(0)}), Matrix(2, 2),
                        Matrix::Zero(2, 2)};
            image.by_state << a * (1 - x(1)) + 2 * c * x(0), -a * x(0), 1, 0;
            image.by_keys.row(0) << x(0) * (1 - x(1)), x(0) * x(0);
            return image;
          },
          vector({1, 1, 1, 1})};
}

TEST(LociTest, OfNeimarkSackerPoints) {
  PowerOfMap map = two_key_delayed_logistic();
  const LocusStart start{
      LocusKind::neimark_sacker, {vector({0.5, 0.5}), vector({2, 0})}, {}, false};
  const Locus locus = follow_locus(map, start, within({0, 10}, {-8, 2}));
  EXPECT_EQ(locus.end, End::bounds) << locus.reason;
  EXPECT_NEAR(locus.points.back().point.keys(0), 4, 1e-12);
  EXPECT_NEAR(locus.points.back().angle, 2 * M_PI / 3, 1e-12);
  for (const LocusPoint &point : locus.points) {
    const double a = point.point.keys(0);
    EXPECT_NEAR(point.point.keys(1), 2 * a - a * a, 1e-12);
    EXPECT_NEAR(std::cos(point.angle), (3 - a) / 2, 1e-12);
    // |mu|^2 = a x with x = (a - 1) / (a - c): its derivative by a at a x = 1
    const double c = point.point.keys(1), change = (a - c) * (2 * a - 1) - a * (a - 1);
    EXPECT_EQ(point.side, change > 0 ? 1 : -1);
  }
  const Locus whole = follow_locus(map, start, within({0, 10}, {-30, 2}));
  EXPECT_EQ(whole.end, End::real_pair) << whole.reason;
  EXPECT_NE(whole.reason.find("1:2"), std::string::npos);
  EXPECT_NEAR(whole.points.back().point.keys(0), 5, 1e-2);
}

// c cos(w t) + s sin(w t) in x'' + x'/10 + x = A cos(w t), with a stop at 1 that it touches where
// A^2 = (1 - w^2)^2 + w^2 / 100.
class Oscillator : public Problem {
public:
  Vector scales() const override { return vector({1, 1, 1, 1}); }
  bool is_map() const override { return false; }
  Evaluation evaluate(const Point &at) override {
    const double c = at.state(0), s = at.state(1), w = at.keys(1), k = 1 - w * w;
    Evaluation result{vector({k * c + 0.1 * w * s - at.keys(0), k * s - 0.1 * w * c}),
                      Matrix(2, 2),
                      Matrix(2, 2),
                      {}};
    result.by_state << k, 0.1 * w, -0.1 * w, k;
    result.by_keys << -1, -2 * w * c + 0.1 * s, 0, -2 * w * s - 0.1 * c;
    return result;
  }
  Extension extend(const Point &at, const Graze &) override {
    Extension result;
    result.smooth = evaluate(at);
    result.value = 1 - at.state.norm();
    result.by_state = -at.state.normalized().transpose();
    result.by_keys = RowVector::Zero(2);
    result.touch = Touch::square_root;
    return result;
  }
};

TEST(LociTest, OfGrazesThroughResonance) {
  Oscillator problem;
  const double k = 1 - 0.25, d = 0.05, amplitude = std::hypot(k, d);
  const Point start{vector({k / amplitude, d / amplitude}), vector({amplitude, 0.5})};
  const Locus locus =
      follow_locus(problem, {LocusKind::graze, start, Graze{}, true}, within({0, 20}, {0.2, 3}));
  EXPECT_EQ(locus.end, End::bounds) << locus.reason;
  EXPECT_DOUBLE_EQ(locus.points.back().point.keys(1), 3);
  for (const LocusPoint &point : locus.points) {
    const double w = point.point.keys(1);
    EXPECT_NEAR(point.point.keys(0), std::hypot(1 - w * w, 0.1 * w), 1e-13);
    EXPECT_EQ(point.side, 1);
  }
}

// Closed in both keys: folds of x^2 + (p - 1)^2 + q^2 - 1 = 0 over p are the circle (p - 1)^2 + q^2
// = 1.
TEST(LociTest, CloseOnThemselves) {
  Algebraic problem(
      [](const Point &at) {
        const double x = at.state(0), p = at.keys(0) - 1, q = at.keys(1);
        return Evaluation{vector({x * x + p * p + q * q - 1}),
                          vector({2 * x}),
                          vector({2 * p, 2 * q}).transpose(),
                          {}};
      },
      vector({1, 1, 1}));
  const Locus locus =
      follow_locus(problem, {LocusKind::fold, {vector({0}), vector({2, 0})}, {}, true}, Settings());
  EXPECT_EQ(locus.end, End::closed) << locus.reason;
  EXPECT_TRUE(locus.special.empty());
  for (const LocusPoint &point : locus.points)
    EXPECT_NEAR(std::hypot(point.point.keys(0) - 1, point.point.keys(1)), 1, 1e-13);
}

// x -> p + a x for x < 0, and p + (m + s q) x + k x^(3/2) behind the corner at x = 0: the
// multiplier m + s q
// + 3/2 k sqrt x is m where sqrt x = -2 s q / (3 k), a curve that ends at q = 0 with p = (1 - m) 0
// = 0.
class Corner : public Problem {
public:
  Corner(double multiplier, double slope, double curvature)
      : m_{multiplier}, s_{slope}, k_{curvature} {}
  Vector scales() const override { return vector({1, 1, 1}); }
  Evaluation evaluate(const Point &at) override {
    const double x = at.state(0), p = at.keys(0), q = at.keys(1);
    if (x <= 0)
      return extend(at, {}).smooth;
    const double root = std::sqrt(x), b = m_ + s_ * q;
    return {vector({p + b * x + k_ * root * x - x}),
            vector({b + 1.5 * k_ * root - 1}),
            vector({1, s_ * x}).transpose(),
            {1}};
  }
  std::vector<Graze> grazes_near(const Point &) override { return {Graze{.name = "the stop"}}; }
  Extension extend(const Point &at, const Graze &) override {
    Extension result;
    result.smooth = {vector({at.keys(0) + (open_ - 1) * at.state(0)}),
                     vector({open_ - 1}),
                     vector({1, 0}).transpose(),
                     {0}};
    result.value = -at.state(0);
    result.by_state = RowVector::Constant(1, -1);
    result.by_keys = RowVector::Zero(2);
    result.touch = Touch::corner;
    result.jump = vector({open_ - m_ - s_ * at.keys(1)});
    return result;
  }

private:
  double m_, s_, k_, open_ = 0.3;
};

TEST(LociTest, EndOnGrazingCurves) {
  for (const LocusKind kind : {LocusKind::fold, LocusKind::flip}) {
    const double m = kind == LocusKind::fold ? 1 : -1, s = -1, k = 0.8;
    Corner problem(m, s, k);
    const double q = 0.7, root = 2 * q / (3 * k), x = root * root;
    const double p = x - (m + s * q) * x - k * root * x;
    const Locus locus = follow_locus(problem, {kind, {vector({x}), vector({p, q})}, {}, false},
                                     within({-3, 3}, {-3, 3}));
    EXPECT_EQ(locus.end, End::graze) << locus.reason;
    EXPECT_NE(locus.reason.find("the stop"), std::string::npos);
    ASSERT_EQ(locus.special.size(), 1u);
    EXPECT_EQ(locus.special[0].kind, LocusSpecial::ends_at_graze);
    EXPECT_LT(locus.special[0].at.point.keys.norm(), 1e-14);
    EXPECT_LT(locus.special[0].at.point.state.norm(), 1e-14);
    EXPECT_LT(locus.special[0].after, locus.points.size());
    for (const LocusPoint &point : locus.points)
      EXPECT_NEAR(point.point.state(0), std::pow(2 * point.point.keys(1) / (3 * k), 2), 1e-12);
  }
}

} // namespace loci_tests
} // namespace vibroimpact::continuation
