// The smooth extension of the map beyond a graze: where a linear vibration first touches a stop, in
// closed form, and what derivatives do behind it.
#include "periodic/graze_extension.h"

#include "common/decompositions.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "continuation/branch.h"
#include "family.h"
#include "periodic/guard_minima.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

namespace vibroimpact::periodic {
namespace grazes_tests {

using continuation::Extension;
using continuation::Point;
using continuation::Touch;
using testing::Family;
using testing::Oscillator;
using testing::oscillator;
using testing::vector_of;

constexpr double damping = 0.1;

// x'' + 0.1 x' + x = a sin(w t): x = Im(A e^(i w t)).
std::complex<double> amplitude(double a, double w) {
  return a / std::complex<double>(1 - w * w, damping * w);
}

Vector state_of(double a, double w, double periods) {
  const std::complex<double> x = amplitude(a, w) * std::polar(1.0, 2 * std::numbers::pi * periods);
  return vector_of({x.imag(), (x * std::complex<double>(0, w)).imag()});
}

Oscillator with_stop(double a, double w, const std::shared_ptr<const contact::ContactLaw> &law) {
  Oscillator model = oscillator(1, 1, damping);
  model.push(a, w);
  model.stop({{1.0, law}});
  return model;
}

// Newton's method for (F, g) = 0 from a point of which a contact is about to graze.
Point graze_from(OrbitProblem &problem, Point point) {
  const std::vector<continuation::Graze> grazes = problem.grazes_near(point);
  EXPECT_FALSE(grazes.empty());
  for (int i = 0; i < 20; ++i) {
    const Extension at = problem.extend(point, grazes.at(0));
    const Index n = point.state.size();
    Matrix matrix(n + 1, n + 1);
    matrix << at.smooth.by_state, at.smooth.by_keys, at.by_state, at.by_keys;
    Vector residual(n + 1);
    residual << at.smooth.residual, at.value;
    const Vector step = -solve_fully_pivoted(matrix, residual);
    point.state += step.head(n);
    point.keys[0] += step[n];
    if (step.norm() < 1e-13)
      break;
  }
  return point;
}

TEST(GrazesTest, FirstTouchOfARigidStop) {
  for (const double w : {0.5, 0.8, 1.25, 2.6})
    for (const double share : {0.97, 1.01}) {
      const double exact = std::hypot(1 - w * w, damping * w);
      Family family([w](double a) { return with_stop(a, w, testing::newton(0.8)); }, false);
      OrbitProblem problem(family, 2, Vector::Ones(3));
      // The touch is where the phase of the motion is a quarter.
      const double touch = 0.25 - std::arg(amplitude(1, w)) / (2 * std::numbers::pi);
      const double chart = touch + 0.4 - std::floor(touch + 0.4);
      const double a = share * exact;
      const Point found =
          graze_from(problem, {.state = share < 1 ? state_of(a, w, chart)
                                                  : Vector(0.99 * state_of(a, w, chart)),
                               .keys = Vector::Constant(1, a),
                               .chart = chart});
      EXPECT_NEAR(found.keys[0], exact, 1e-12) << w;
      EXPECT_LT((found.state - state_of(exact, w, chart)).norm(), 1e-11) << w;
      const Extension at = problem.extend(found, problem.grazes_near(found).at(0));
      EXPECT_EQ(at.touch, Touch::square_root);
    }
}

// Two harmonics: all minima of the gap of a motion that never touches, wherever a period begins.
TEST(GrazesTest, AllMinimaOfTheGap) {
  const double w = 0.3;
  Oscillator model = oscillator(1, 1, damping);
  model.push(0.3, w);
  model.push(0.1, 3 * w, 0.4);
  model.stop({{1.0, testing::newton(0.8)}}, {{1.0, testing::newton(0.8)}});
  const testing::ForcedMap forced(model, false);
  const Orbit orbit = find_orbit(forced.map, 1, Vector::Zero(2));
  const auto first = amplitude(0.3, w);
  const auto third = amplitude(0.1, 3 * w) * std::polar(1.0, 0.4);
  const auto position = [&](double phase) {
    const double angle = 2 * std::numbers::pi * phase;
    return (first * std::polar(1.0, angle) + third * std::polar(1.0, 3 * angle)).imag();
  };
  std::vector<double> peaks, troughs;
  constexpr int grid = 100000;
  for (int i = 0; i < grid; ++i) {
    const double before = position((i - 1.0) / grid), at = position(1.0 * i / grid),
                 after = position((i + 1.0) / grid);
    if (at > before && at >= after)
      peaks.push_back(at);
    if (at < before && at <= after)
      troughs.push_back(-at);
  }
  ASSERT_GT(peaks.size(), 1u);
  for (const double begin : {0.0, 0.13, 0.37, 0.71}) {
    MinimumObserver observer(forced.system.contacts());
    const Vector state = forced.map.carry(0, begin, state_at_zero_phase(forced.map, orbit));
    forced.map.observe(begin, begin + 1, state, observer);
    for (const std::size_t contact : {0u, 1u}) {
      std::vector<double> expected = contact == 0 ? peaks : troughs, found;
      for (const GuardMinimum &minimum : observer.minima())
        if (minimum.contact == contact)
          found.push_back(1 - minimum.value);
      std::sort(expected.begin(), expected.end());
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found.size(), expected.size()) << begin;
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-8);
    }
  }
}

// Over the frequency, where the instants of the graze and of the section move.
TEST(GrazesTest, FirstTouchesOfTheIsolator) {
  Family family([](double lambda) { return testing::isolator(lambda); });
  OrbitProblem problem(family, 1, Vector::Ones(3));
  for (const double sign : {-1.0, 1.0}) {
    // (1 - l^2)^2 + (2 zeta l)^2 = f^2
    const double b = 1 - 2 * 0.01 * 0.01;
    const double exact = std::sqrt(b + sign * std::sqrt(b * b - 1 + 0.52 * 0.52));
    const double lambda = exact + sign * 0.002;
    const Orbit orbit = find_orbit(family.at(lambda), 1, vector_of({0, -1}));
    const Point found = graze_from(problem, {.state = orbit.point.state,
                                             .keys = Vector::Constant(1, lambda),
                                             .chart = orbit.section.phase});
    EXPECT_NEAR(found.keys[0], exact, 1e-12);
    EXPECT_NEAR(found.keys[0], sign < 0 ? 0.69295362 : 1.23264564, 5e-9);
    EXPECT_EQ(problem.extend(found, problem.grazes_near(found).at(0)).touch, Touch::smooth);
  }
}

// All derivatives of the extension and of the least value, by differences.
void expect_derivatives(OrbitProblem &problem, const Point &point,
                        const continuation::Graze &graze) {
  const Extension exact = problem.extend(point, graze);
  const double h = 1e-4;
  for (Index j = 0; j < 3; ++j) {
    const auto at = [&](double by) {
      Point moved = point;
      (j < 2 ? moved.state[j] : moved.keys[0]) += by;
      const Extension other = problem.extend(moved, graze);
      Vector all(3);
      all << other.smooth.residual, other.value;
      return all;
    };
    const Vector difference = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    Vector column(3);
    if (j < 2)
      column << exact.smooth.by_state.col(j), exact.by_state[j];
    else
      column << exact.smooth.by_keys, exact.by_keys;
    EXPECT_LT((column - difference).norm(), 1e-7 * difference.norm()) << j;
  }
}

TEST(GrazesTest, DerivativesOfTheExtension) {
  Family family([](double lambda) { return testing::isolator(lambda); }, false);
  OrbitProblem problem(family, 2, Vector::Ones(3));
  const double lambda = 1.236;
  const Orbit orbit = find_orbit(family.at(lambda), 1, vector_of({0, -1}));
  const Point point{.state = orbit.point.state,
                    .keys = Vector::Constant(1, lambda),
                    .chart = orbit.section.phase};
  const std::vector<continuation::Graze> grazes = problem.grazes_near(point);
  ASSERT_GE(grazes.size(), 2u);
  for (const continuation::Graze &graze : grazes)
    expect_derivatives(problem, point, graze);
}

// A gap that the source itself changes, with a section so close before the graze that the contact
// is kept open from the section on.
TEST(GrazesTest, DerivativesWhereAMovingStopGrazesSoonAfterTheSection) {
  const double w = 0.8, a = 0.36;
  Family family(
      [](double omega) {
        Oscillator model = with_stop(0.36, omega, std::make_shared<contact::KelvinVoigt>(50, 0));
        std::vector<contact::ContactPair> pairs = model.contacts.pairs();
        pairs[0].gap.base_coefficients = {-0.1};
        model.contacts = contact::ContactSet(std::move(pairs));
        return model;
      },
      false);
  OrbitProblem problem(family, 2, Vector::Ones(3));
  // The gap is 1 - x - 0.1 a sin(w t), x + 0.1 a sin(w t) = Im((A + 0.1 a) e^(i w t)).
  const double touch = 0.25 - std::arg(amplitude(a, w) + 0.1 * a) / (2 * std::numbers::pi);
  const double chart = touch - 0.1 - std::floor(touch - 0.1);
  const Point point{.state = state_of(a, w, chart), .keys = Vector::Constant(1, w), .chart = chart};
  const std::vector<continuation::Graze> grazes = problem.grazes_near(point);
  ASSERT_FALSE(grazes.empty());
  EXPECT_NEAR(problem.extend(point, grazes[0]).value, 1 - std::abs(amplitude(a, w) + 0.1 * a),
              1e-9);
  expect_derivatives(problem, point, grazes[0]);
}

// A dashpot that lets go keeps its impulse of the way in: derivatives a little behind the graze are
// those of the extension plus the jump, up to the square root of the depth.
TEST(GrazesTest, CornerBehindAGraze) {
  const double w = 0.8, k = 2, c = 0.7;
  const std::shared_ptr<const contact::ContactLaw> laws[] = {
      std::make_shared<contact::KelvinVoigt>(k, c),
      std::make_shared<contact::KelvinVoigtBumper>(k, c)};
  for (const auto &law : laws) {
    Family family([&](double a) { return with_stop(a, w, law); }, false);
    OrbitProblem problem(family, 2, Vector::Ones(3 + law->n_internal()));
    const double grazing = std::hypot(1 - w * w, damping * w);
    const double touch = 0.25 - std::arg(amplitude(1, w)) / (2 * std::numbers::pi);
    const double chart = touch + 0.6 - std::floor(touch + 0.6);
    double last = 1;
    for (const double depth : {1e-6, 1e-8}) {
      const double a = grazing * (1 + depth);
      Vector state = Vector::Zero(2 + law->n_internal());
      state.head(2) = state_of(a, w, chart);
      const Point point{.state = state, .keys = Vector::Constant(1, a), .chart = chart};
      const std::vector<continuation::Graze> grazes = problem.grazes_near(point);
      ASSERT_EQ(grazes.size(), 1u);
      const Extension at = problem.extend(point, grazes[0]);
      EXPECT_NEAR(at.value, -depth, 1e-3 * depth);
      ASSERT_EQ(at.touch, Touch::corner);
      const Matrix behind = problem.evaluate(point).by_state;
      const Matrix expected = at.smooth.by_state + at.jump * at.by_state;
      EXPECT_GT((behind - at.smooth.by_state).norm(), 0.1);
      const double error = (behind - expected).norm();
      EXPECT_LT(error, 10 * std::sqrt(depth));
      EXPECT_LT(error, last);
      last = error;
    }
  }
}

// Pressed on a stop by 1/2 as long as the force does not let go:
//
//     x'' + (0.1 + c) x' + (1 + k) x = -k / 2 + a sin(w t),   force k (1/2 + x) + c x'
//
// of which k / (2 (1 + k)) is constant, and |k + i c w| |X| vibrates.
struct Pressed {
  double w, k, c;
  std::complex<double> amplitude(double a) const {
    return a / std::complex<double>(1 + k - w * w, (damping + c) * w);
  }
  double grazing() const {
    return k / (2 * (1 + k)) / std::abs(std::complex<double>(k, c * w) * amplitude(1));
  }
  // A section this far behind the least force.
  double section(double behind) const {
    const double angle = std::arg(std::complex<double>(k, c * w) * amplitude(1));
    const double phase = -0.25 - angle / (2 * std::numbers::pi) + behind;
    return phase - std::floor(phase);
  }
  // With the compression of a stop that has one.
  Vector state(double a, double periods, Index size) const {
    const std::complex<double> x = amplitude(a) * std::polar(1.0, 2 * std::numbers::pi * periods);
    const double place = x.imag() - k / (2 * (1 + k));
    Vector all(size);
    all << place, (x * std::complex<double>(0, w)).imag(), Vector::Constant(size - 2, 0.5 + place);
    return all;
  }
};

std::vector<std::shared_ptr<const contact::ContactLaw>> pressed_laws(double k, double c) {
  if (c == 0)
    return {std::make_shared<contact::LinearPenalty>(k)};
  return {std::make_shared<contact::KelvinVoigt>(k, c),
          std::make_shared<contact::KelvinVoigtBumper>(k, c)};
}

Family pressed_family(double w, const std::shared_ptr<const contact::ContactLaw> &law) {
  return Family(
      [w, law](double a) {
        Oscillator model = oscillator(1, 1, damping);
        model.push(a, w);
        model.stop({{-0.5, law}});
        return model;
      },
      false);
}

// The first release, or the end of the force inside, from both sides of it and for any section.
TEST(GrazesTest, FirstReleaseOfAPressedContact) {
  for (const Pressed pressed : {Pressed{1.5, 8, 0}, Pressed{4, 8, 0}, Pressed{1.5, 8, 0.3}})
    for (const auto &law : pressed_laws(pressed.k, pressed.c))
      for (const double share : {0.97, 1.0003}) {
        const Index size = 2 + law->n_internal();
        Family family = pressed_family(pressed.w, law);
        OrbitProblem problem(family, 2, Vector::Ones(size + 1));
        for (const double behind : {0.2, 0.5, 0.8}) {
          const double chart = pressed.section(behind);
          const double a = share * pressed.grazing();
          const Point found = graze_from(problem, {.state = pressed.state(a, chart, size),
                                                   .keys = Vector::Constant(1, a),
                                                   .chart = chart});
          EXPECT_NEAR(found.keys[0], pressed.grazing(), 1e-12) << pressed.w << " " << pressed.c;
          const Extension at = problem.extend(found, problem.grazes_near(found).at(0));
          EXPECT_EQ(at.touch, Touch::smooth);
          EXPECT_LT((found.state - pressed.state(pressed.grazing(), chart, size)).norm(), 1e-11);
        }
      }
}

// Behind it derivatives are those of the extension but for the root of the depth.
TEST(GrazesTest, DerivativesAreContinuousAtARelease) {
  const Pressed pressed{1.5, 8, 0.3};
  for (const auto &law : pressed_laws(pressed.k, pressed.c)) {
    const Index size = 2 + law->n_internal();
    Family family = pressed_family(pressed.w, law);
    OrbitProblem problem(family, 2, Vector::Ones(size + 1));
    double last = 1;
    for (const double depth : {1e-4, 1e-6, 1e-8}) {
      const double a = (1 + depth) * pressed.grazing();
      const Point point{
          .state = pressed.state(a, 0.2, size), .keys = Vector::Constant(1, a), .chart = 0.2};
      const Extension at = problem.extend(point, problem.grazes_near(point).at(0));
      EXPECT_LT(at.value, 0);
      const double error = (problem.evaluate(point).by_state - at.smooth.by_state).norm();
      EXPECT_GT(error, 0);
      EXPECT_LT(error, 30 * std::sqrt(depth));
      EXPECT_LT(error, last);
      last = error / 3;
    }
  }
}

// The branch passes it, wherever its steps lie.
TEST(GrazesTest, BranchesPassTheFirstRelease) {
  const Pressed pressed{1.5, 8, 0};
  const double exact = pressed.grazing();
  Family family = pressed_family(pressed.w, pressed_laws(pressed.k, pressed.c).at(0));
  for (const double step : {0.1, 0.05, 0.017}) {
    OrbitProblem problem(family, 2, Vector::Ones(3));
    continuation::Settings settings;
    settings.first_key = {.lower = 0.9 * exact, .upper = 1.1 * exact};
    settings.longest_step = settings.first_step = step;
    const continuation::Branch branch =
        follow(problem,
               {.point = {.state = pressed.state(0.95 * exact, 0, 2),
                          .keys = Vector::Constant(1, 0.95 * exact)},
                .direction = {}},
               settings);
    EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
    ASSERT_EQ(branch.special.size(), 1u) << step;
    EXPECT_EQ(branch.special[0].kind, continuation::Special::graze);
    EXPECT_NEAR(branch.special[0].at.point.keys[0], exact, 1e-12);
  }
}

} // namespace grazes_tests
} // namespace vibroimpact::periodic
