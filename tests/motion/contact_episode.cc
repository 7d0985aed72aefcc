// Contacts solved in one step, against closed forms.
#include "motion/episode/contact_episode.h"

#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/tsuji.h"
#include "support/power_force.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace vibroimpact::motion {
namespace contact_episode_tests {

// A mass on a spring and a damper, x = (u, u'): m u'' + c u' + s u = -f. The mass of 1 kg.
struct Oscillator {
  Oscillator(double stiffness, double damping)
      : flow({{.places = {0, 1},
               .generator = (Matrix(2, 2) << 0, 1, -stiffness, -damping).finished()}},
             Vector::Unit(2, 1) * -1),
        output(flow, Vector::Unit(2, 0), 0, ContactEpisode::most_terms) {}
  ForcedFlow flow;
  ForcedOutput output;
};

// T = 2 u_max / v integral of ds / sqrt(1 - s^(n+1)) over [0, 1], a Beta function.
double free_duration(double k, double n, double speed) {
  const double largest = std::pow((n + 1) * speed * speed / (2 * k), 1 / (n + 1));
  return 2 * largest / speed * std::beta(1 / (n + 1), 0.5) / (n + 1);
}

TEST(ContactEpisode, LastsAsLongAsThatOfFreeSpheres) {
  const Oscillator free(0, 0);
  for (const double n : {1.0, 1.5, 2.2}) {
    const PowerForce force(1e9, n, 0);
    ContactEpisode contact(free.output, force, {n}, {n}, 1e-9);
    for (const double speed : {1.0, 0.3, 7.0}) {
      const Vector x = Vector::Unit(2, 1) * speed;
      ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none) << "n = " << n;
      EXPECT_NEAR(contact.duration() / free_duration(1e9, n, speed), 1, 2e-8) << "n = " << n;
      EXPECT_NEAR(contact.impulse(), 2 * speed, 1e-9 * speed);
      EXPECT_NEAR(contact.release_speed(), speed, 1e-9 * speed);
      EXPECT_NEAR(contact.mass(), 1, 1e-15);
    }
  }
}

// The duration of free spheres under F = k u^(3/2) to the power that the first singular term beside
// the weight leaves: x^(n + 1) in f / w, whose coefficients fall like nodes^-(2 (n + 1) + ...).
TEST(ContactEpisode, GainsDigitsWithNodes) {
  const Oscillator free(0, 0);
  const PowerForce force(1e9, 1.5, 0);
  const Vector x = Vector::Unit(2, 1);
  double before = 1;
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    ContactEpisode contact(free.output, force, {1.5}, {1.5}, tolerance);
    for (int i = 0; i < 20; ++i) // takes fewer nodes where the tolerance allows it
      ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none);
    const double error = std::abs(contact.duration() / free_duration(1e9, 1.5, 1) - 1);
    EXPECT_LE(error, 10 * tolerance) << contact.nodes();
    EXPECT_LE(error, before);
    before = error;
  }
}

// V - ln(1 + V) = -W - ln(1 - W) with V = d v before and W = d v after the contact, whatever n is.
TEST(ContactEpisode, RestoresAsHuntCrossleySays) {
  const Oscillator free(0, 0);
  for (const double n : {1.5, 2.2})
    for (const double restitution : {0.5, 0.7, 0.9}) {
      // By bisection for V: W = e V.
      const auto residual = [&](double v) {
        return v - std::log1p(v) + restitution * v + std::log1p(-restitution * v);
      };
      double low = 1e-6;
      double high = (1 - 1e-12) / restitution;
      for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (residual(middle) > 0 ? low : high) = middle;
      }
      const double speed = 0.4;
      const PowerForce force(1e8, n, low / speed);
      ContactEpisode contact(free.output, force, {n}, {n}, 1e-8);
      const Vector x = Vector::Unit(2, 1) * speed;
      ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none) << "e = " << restitution;
      EXPECT_NEAR(contact.release_speed(), restitution * speed, 1e-8 * speed);
      const double lost = 0.5 * speed * speed * (1 - restitution * restitution);
      EXPECT_NEAR(contact.dissipated(), lost, 1e-7 * lost);
    }
}

// A linear law is part of an oscillator: u = v / w exp(-c t / 2) sin(w t) between touch and
// release.
TEST(ContactEpisode, IsHalfATurnOfALinearOscillator) {
  const double spring = 4e4;
  const double stop = 1e6;
  const double damping = 150;
  const Oscillator oscillator(spring, damping);
  const PowerForce force(stop, 1, 0);
  ContactEpisode contact(oscillator.output, force, {1}, {1}, 1e-12);
  const double speed = 0.7;
  const Vector x = Vector::Unit(2, 1) * speed;
  ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none);
  const double w = std::sqrt(spring + stop - 0.25 * damping * damping);
  const double duration = std::numbers::pi / w;
  EXPECT_NEAR(contact.duration() / duration, 1, 1e-12);
  EXPECT_NEAR(contact.release_speed() / (speed * std::exp(-0.5 * damping * duration)), 1, 1e-11);
  for (int j = 0; j < contact.nodes(); ++j) {
    const double t = duration * contact.tools().family.nodes()[j];
    const double u = speed / w * std::exp(-0.5 * damping * t) * std::sin(w * t);
    EXPECT_NEAR(contact.penetrations()[j], u, 1e-11 * speed / w);
    EXPECT_NEAR(contact.forces()[j], stop * u, 1e-10 * stop * speed / w);
  }
}

// The state at the end and between, in the coordinates of the system: free motion and force.
TEST(ContactEpisode, MovesTheWholeSystem) {
  const double spring = 4e4;
  const double stop = 1e6;
  const Oscillator oscillator(spring, 0);
  const PowerForce force(stop, 1, 0);
  ContactEpisode contact(oscillator.output, force, {1}, {1}, 1e-9);
  const Vector x = Vector::Unit(2, 1) * 0.7;
  ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none);
  const double w = std::sqrt(spring + stop);
  const double free = std::sqrt(spring);
  ShownPoints &shown = contact.tools().shown(9);
  const std::vector<double> moments = contact.moments(shown.between);
  for (int i = 0; i < shown.between.n_targets(); ++i) {
    const double t = static_cast<double>(shown.rule.nodes[i + 1]) * contact.duration();
    Vector state = Vector::Zero(2);
    state << x[1] / free * std::sin(free * t), x[1] * std::cos(free * t);
    oscillator.flow.add(contact.duration(), moments.data() + i * contact.terms(), contact.terms(),
                        state.data());
    EXPECT_NEAR(state[0], x[1] / w * std::sin(w * t), 1e-10 * x[1] / w);
    EXPECT_NEAR(state[1], x[1] * std::cos(w * t), 1e-10 * x[1]);
  }
}

// What was kept from the contact before changes the way to the solution only.
TEST(ContactEpisode, DependsLittleOnTheOneBefore) {
  const Oscillator oscillator(3e4, 20);
  const PowerForce force(1e8, 1.5, 0);
  ContactEpisode fresh(oscillator.output, force, {1.5}, {1.5}, 1e-9);
  ContactEpisode used(oscillator.output, force, {1.5}, {1.5}, 1e-9);
  const Vector before = Vector::Unit(2, 1) * 0.2;
  const Vector x = Vector::Unit(2, 1) * 0.5;
  ASSERT_EQ(used.solve(before.data(), 1), Refusal::none);
  ASSERT_EQ(used.solve(x.data(), 1), Refusal::none);
  ASSERT_EQ(fresh.solve(x.data(), 1), Refusal::none);
  EXPECT_NEAR(used.duration() / fresh.duration(), 1, 1e-9);
  EXPECT_NEAR(used.release_speed() / fresh.release_speed(), 1, 1e-9);
  EXPECT_LE(used.sweeps(), fresh.sweeps());
  used.forget();
  ASSERT_EQ(used.solve(x.data(), 1), Refusal::none);
  EXPECT_EQ(used.duration(), fresh.duration()); // to the last bit
}

// Between free bodies all contacts of a law look alike: two sweeps confirm what was kept.
TEST(ContactEpisode, KeepsItsShape) {
  const Oscillator free(0, 0);
  const PowerForce force(1e9, 1.5, 0);
  ContactEpisode contact(free.output, force, {1.5}, {1.5}, 1e-9);
  const Vector x = Vector::Unit(2, 1);
  const Vector faster = 5 * x;
  ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none);
  EXPECT_GT(contact.sweeps(), 2);
  ASSERT_EQ(contact.solve(faster.data(), 1), Refusal::none);
  EXPECT_EQ(contact.sweeps(), 2);
}

// The restitution of two free bodies is exp(-pi z / sqrt(1 - z^2)), z = alpha / sqrt(5), at every
// speed. The force pulls at the end.
TEST(ContactEpisode, RestoresAsTsujiSays) {
  const Oscillator free(0, 0);
  for (const double alpha : {0.05, 0.3, 0.8}) {
    const double stiffness = 1e9;
    const contact::Tsuji law(stiffness, alpha * std::sqrt(stiffness));
    const LawForce force(law, 1);
    const contact::ForcePulse course = *law.force_pulse(1);
    ContactEpisode contact(free.output, force, course.begin, course.ends[0].edge, 1e-9);
    const double z = alpha / std::sqrt(5.0);
    const double restitution = std::exp(-std::numbers::pi * z / std::sqrt(1 - z * z));
    for (const double speed : {1.0, 0.01}) {
      const Vector x = Vector::Unit(2, 1) * speed;
      ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none) << "alpha = " << alpha;
      EXPECT_NEAR(contact.release_speed(), restitution * speed, 2e-9 * speed) << contact.nodes();
      const double lost = 0.5 * speed * speed * (1 - restitution * restitution);
      EXPECT_NEAR(contact.dissipated(), lost, 1e-8 * speed * speed);
      EXPECT_GT(contact.pulling_impulse(), 0);
    }
  }
}

// State of a mass on a linear spring under a law, by very many steps of the classical Runge-Kutta
// method in sqrt(t), up to the instant at which its force ends: (t, u, u').
std::array<double, 3> cut_off(const contact::ContactLaw &law, double spring, double offset,
                              double speed, const contact::AffineForm &push) {
  contact::LawResponse response;
  const auto slope = [&](double s, const std::array<double, 2> &y) {
    law.evaluate(1, {.gap = -y[0], .gap_rate = -y[1]}, response);
    const double acceleration = -spring * (y[0] + offset) - response.force;
    return std::array<double, 2>{2 * s * y[1], 2 * s * acceleration};
  };
  std::array<double, 2> y = {0, speed};
  double s = 0;
  const auto step = [&](double h) {
    const auto moved = [&](const std::array<double, 2> &k, double part) {
      return std::array<double, 2>{y[0] + part * k[0], y[1] + part * k[1]};
    };
    const auto k1 = slope(s, y);
    const auto k2 = slope(s + h / 2, moved(k1, h / 2));
    const auto k3 = slope(s + h / 2, moved(k2, h / 2));
    const auto k4 = slope(s + h, moved(k3, h));
    for (std::size_t i = 0; i < 2; ++i)
      y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    s += h;
  };
  constexpr double length = 2e-6; // of a step, in sqrt(s)
  while (push({.gap = -y[0], .gap_rate = -y[1]}) > 0)
    step(length);
  double back = -length; // by the secant rule
  double value = push({.gap = -y[0], .gap_rate = -y[1]});
  for (int i = 0; i < 6 && value != 0; ++i) {
    step(back);
    const double present = push({.gap = -y[0], .gap_rate = -y[1]});
    back *= present / (value - present);
    value = present;
    if (back == 0)
      break;
  }
  return {s * s, y[0], y[1]};
}

// Where the sides still overlap: by the law of Kuwabara and Kono always, by that of Hunt and
// Crossley where something else pulls them apart.
TEST(ContactEpisode, EndsWhereTheForceIsCutOff) {
  const contact::KuwabaraKono kuwabara_kono(1e6, 1e-3);
  const auto hunt_crossley = contact::HuntCrossley::with_dissipation({.stiffness = 1e6}, 1.5);
  struct Case {
    const contact::ContactLaw &law;
    double spring, offset, tolerance;
  };
  for (const Case &tried :
       {Case{kuwabara_kono, 100, 0, 1e-10}, Case{*hunt_crossley, 1e4, 0.02, 1e-8}}) {
    const LawForce force(tried.law, 1);
    const contact::ForcePulse course = *tried.law.force_pulse(1);
    const contact::ForcePulse::End &end = course.ends.back();
    const contact::AffineForm &push = tried.law.modes()[1].guards[end.guard].indicator;
    const Oscillator oscillator(tried.spring, 0);
    const ForcedOutput output(oscillator.flow, Vector::Unit(2, 0), -tried.offset,
                              ContactEpisode::most_terms);
    ContactEpisode contact(output, force, course.begin, end.edge, tried.tolerance);
    contact.set_end({push.constant, -push.gap, -push.gap_rate});
    const double speed = 0.7;
    const Vector x{{tried.offset, speed}};
    ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none) << tried.law.name();
    const auto [t, u, rate] = cut_off(tried.law, tried.spring, tried.offset, speed, push);
    EXPECT_NEAR(contact.duration() / t, 1, 10 * tried.tolerance) << tried.law.name();
    EXPECT_NEAR(contact.penetrations()[contact.nodes()] / u, 1, 100 * tried.tolerance)
        << tried.law.name();
    EXPECT_NEAR(contact.rates()[contact.nodes()] / rate, 1, 10 * tried.tolerance)
        << tried.law.name();
  }
}

// Pressed on by a load that the force cannot throw off within the time given.
TEST(ContactEpisode, SaysWhatItCannotDo) {
  const Oscillator oscillator(3e4, 0);
  const PowerForce force(1e8, 1.5, 0);
  ContactEpisode contact(oscillator.output, force, {1.5}, {1.5}, 1e-9);
  const Vector away = Vector::Unit(2, 1) * -0.1;
  EXPECT_EQ(contact.solve(away.data(), 1), Refusal::no_approach);
  const Vector x = Vector::Unit(2, 1) * 0.1;
  ASSERT_EQ(contact.solve(x.data(), 1), Refusal::none);
  EXPECT_EQ(contact.solve(x.data(), 0.9 * contact.duration()), Refusal::too_long);
  const Oscillator stiff(1e12, 0);
  ContactEpisode slow(stiff.output, PowerForce(1e3, 1.5, 0), {1.5}, {1.5}, 1e-9);
  EXPECT_NE(slow.solve(x.data(), 1), Refusal::none);
}

} // namespace contact_episode_tests
} // namespace vibroimpact::motion
