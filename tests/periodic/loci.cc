// Loci of special points of periodic motions in two keys: against closed forms and values of an
// independent continuation.
#include "continuation/locus.h"

#include "contact/laws/linear_penalty.h"
#include "family.h"

#include <gtest/gtest.h>

#include <complex>

namespace vibroimpact::periodic {
namespace loci_tests {

using continuation::End;
using continuation::Locus;
using continuation::LocusKind;
using continuation::LocusPoint;
using continuation::Point;
using testing::Family;
using testing::Oscillator;
using testing::oscillator;
using testing::vector_of;

constexpr double damping = 0.1;

double grazing(double w) { return std::hypot(1 - w * w, damping * w); }

// x'' + 0.1 x' + x = a sin(w t) before a rigid stop at 1: keys a and w.
Oscillator rigid(const Vector &keys) {
  Oscillator model = oscillator(1, 1, damping);
  model.push(keys[0], keys[1]);
  model.stop({{1.0, testing::newton(0.8)}});
  return model;
}

// The response is 1 there; a section 0.4 of the period behind the touch.
Point touching(double w) {
  const std::complex<double> unit = 1.0 / std::complex<double>(1 - w * w, damping * w);
  const double touch = 0.25 - std::arg(unit) / (2 * std::numbers::pi);
  const double chart = touch + 0.4 - std::floor(touch + 0.4);
  const std::complex<double> x = grazing(w) * unit * std::polar(1.0, 2 * std::numbers::pi * chart);
  return {.state = vector_of({x.imag(), (x * std::complex<double>(0, w)).imag()}),
          .keys = vector_of({grazing(w), w}),
          .chart = chart};
}

// Through the resonance, where the instant of the graze moves by half a period.
TEST(LociTest, GrazesOfARigidStopThroughResonance) {
  Family family(Family::Make(rigid), false);
  OrbitProblem problem(family, 2, vector_of({1, 1, 10, 3}));
  const Point start = touching(0.8);
  continuation::Settings settings;
  settings.longest_step = 0.05;
  settings.first_key = {.lower = 0, .upper = 10};
  settings.second_key = {.lower = 0.29, .upper = 3};
  for (const bool forward : {true, false}) {
    const auto grazes = problem.grazes_near(start);
    ASSERT_FALSE(grazes.empty());
    const Locus locus = follow_locus(
        problem, {.kind = LocusKind::graze, .point = start, .graze = grazes[0], .forward = forward},
        settings);
    EXPECT_EQ(locus.end, End::bounds) << locus.reason;
    EXPECT_DOUBLE_EQ(locus.points.back().point.keys[1], forward ? 3 : 0.29);
    double charts = 0;
    for (const LocusPoint &point : locus.points) {
      EXPECT_NEAR(point.point.keys[0], grazing(point.point.keys[1]), 1e-12);
      charts += point.point.chart != start.chart ? 1 : 0;
      // Without the touch the multipliers are those of the free vibration.
      const double period = 2 * std::numbers::pi / point.point.keys[1];
      EXPECT_NEAR((point.by_state + Matrix::Identity(2, 2)).determinant(),
                  std::exp(-damping * period), 1e-9);
    }
    EXPECT_EQ(charts > 0, forward); // half a period over the resonance
  }
}

// Pressed on a spring of 8 by 1/2: the contact lets go where 8 |X| is the constant force 4 / 9.
TEST(LociTest, GrazesOfAReleaseThroughResonance) {
  Family family(Family::Make([](const Vector &keys) {
                  Oscillator model = oscillator(1, 1, damping);
                  model.push(keys[0], keys[1]);
                  model.stop({{-0.5, std::make_shared<contact::LinearPenalty>(8)}});
                  return model;
                }),
                false);
  const auto exact = [](double w) { return std::hypot(9 - w * w, damping * w) / 18; };
  const Vector keys = vector_of({0.999 * exact(2), 2});
  const Orbit orbit = find_orbit(family.at(keys), 1, vector_of({-4.0 / 9, 0}));
  OrbitProblem problem(family, 2, vector_of({0.1, 0.1, 1, 3}));
  const Point start{.state = orbit.point.state, .keys = keys, .chart = orbit.section.phase};
  const auto grazes = problem.grazes_near(start);
  ASSERT_FALSE(grazes.empty());
  continuation::Settings settings;
  settings.longest_step = 0.05;
  settings.first_key = {.lower = 0, .upper = 1};
  settings.second_key = {.lower = 1, .upper = 4};
  for (const bool forward : {true, false}) {
    const Locus locus = follow_locus(
        problem, {.kind = LocusKind::graze, .point = start, .graze = grazes[0], .forward = forward},
        settings);
    EXPECT_EQ(locus.end, End::bounds) << locus.reason;
    EXPECT_DOUBLE_EQ(locus.points.back().point.keys[1], forward ? 4 : 1);
    for (const LocusPoint &point : locus.points)
      EXPECT_NEAR(point.point.keys[0], exact(point.point.keys[1]), 1e-12);
  }
}

// Half the motion of a symmetric model, whose stops take turns where the section moves: the first
// touch over the frequency and the amplitude.
TEST(LociTest, GrazesOfASymmetricMotion) {
  Family family(
      Family::Make([](const Vector &keys) { return testing::isolator(keys[1], 2, keys[0]); }));
  OrbitProblem problem(family, 1, vector_of({1, 1, 3, 2}));
  const auto exact = [](double w) { return std::hypot(1 - w * w, 0.02 * w); };
  const Vector keys = vector_of({exact(0.7) * 0.999, 0.7});
  const Orbit orbit = find_orbit(family.at(keys), 1, vector_of({0, 0.5}));
  const Point start{.state = orbit.point.state, .keys = keys, .chart = orbit.section.phase};
  const auto grazes = problem.grazes_near(start);
  ASSERT_FALSE(grazes.empty());
  continuation::Settings settings;
  settings.longest_step = 0.05;
  settings.first_key = {.lower = 0, .upper = 3};
  settings.second_key = {.lower = 0.3, .upper = 1.8};
  const Locus locus = follow_locus(
      problem, {.kind = LocusKind::graze, .point = start, .graze = grazes[0], .forward = true},
      settings);
  EXPECT_EQ(locus.end, End::bounds) << locus.reason;
  EXPECT_DOUBLE_EQ(locus.points.back().point.keys[1], 1.8);
  for (const LocusPoint &point : locus.points)
    EXPECT_NEAR(point.point.keys[0], exact(point.point.keys[1]), 1e-12);
}

// A touch that lies before the new section comes half a period later, at the other stop: the orbit
// stays one, and its least gap what it was.
TEST(LociTest, GrazesOfASymmetricMotionFromEverySection) {
  Family family(
      Family::Make([](const Vector &keys) { return testing::isolator(keys[1], 2, keys[0]); }));
  OrbitProblem problem(family, 1, vector_of({1, 1, 3, 2}));
  const double w = 0.7, gap = 1e-3;
  const Vector keys = vector_of({std::hypot(1 - w * w, 0.02 * w) * (1 - gap), w});
  const Orbit orbit = find_orbit(family.at(keys), 1, vector_of({0, 0.5}));
  const Point start{.state = orbit.point.state, .keys = keys, .chart = orbit.section.phase};
  const auto grazes = problem.grazes_near(start);
  ASSERT_FALSE(grazes.empty());
  for (const double chart : {0.05, 0.15, 0.25, 0.35, 0.45}) {
    const auto extended = problem.extended(grazes[0]);
    EXPECT_NEAR(extended->extend(start, grazes[0]).value, gap, 1e-10);
    const Point moved = extended->transfer(start, chart).point;
    const auto there = extended->extend(moved, grazes[0]);
    EXPECT_LT(there.smooth.residual.norm(), 1e-9) << chart;
    EXPECT_NEAR(there.value, gap, 1e-9) << chart;
  }
}

// Derivatives of the residual by both keys, by differences.
TEST(LociTest, DerivativesByTwoKeys) {
  Family family(
      Family::Make([](const Vector &keys) { return testing::isolator(keys[0], keys[1]); }));
  OrbitProblem problem(family, 1, vector_of({1, 1, 1, 1}));
  const Point point{.state = vector_of({-0.3, -1.5}), .keys = vector_of({1.3, 2.1}), .chart = 0.13};
  const Matrix exact = problem.evaluate(point).by_keys;
  ASSERT_EQ(exact.cols(), 2);
  const double h = 1e-3;
  for (Index k = 0; k < 2; ++k) {
    const auto at = [&](double by) {
      Point moved = point;
      moved.keys[k] += by;
      return problem.evaluate(moved).residual;
    };
    const Vector difference = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    EXPECT_LT((exact.col(k) - difference).norm(), 1e-7 * difference.norm()) << k;
  }
}

} // namespace loci_tests
} // namespace vibroimpact::periodic
