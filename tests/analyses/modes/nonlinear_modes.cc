// Nonlinear modes: frequency and energy of undamped motions in closed form, with stops of all kinds
// and a cubic spring; where they lose their symmetry; runs that are resumed.
#include "analyses/modes/known_modes.h"

#include "common/zero.h"
#include "contact/laws/hertz.h"
#include "contact/laws/linear_penalty.h"

#include <cstring>

namespace vibroimpact::analyses {
namespace nonlinear_modes_tests {

using namespace known_modes;
using testing::field_of;

TEST(NonlinearModes, LinearModesKeepTheirFrequency) {
  const double golden = (std::sqrt(5) - 1) / 2;
  for (const long mode : {1L, 2L}) {
    const PointResult result = mode_of(two_masses(), between(0.1, 5, mode));
    const Backbone backbone(result);
    EXPECT_EQ(backbone.energy.front(), 0.1);
    EXPECT_DOUBLE_EQ(backbone.energy.back(), 5);
    for (const double omega : backbone.omega)
      EXPECT_NEAR(omega, mode == 1 ? golden : 1 + golden, 1e-12);
    for (const double stable : field_of(result, "stable").values)
      EXPECT_EQ(stable, 1);
    for (const double excitation : field_of(result, "self_excitation").values)
      EXPECT_EQ(excitation, 0);
  }
}

// Half a period on each side.
TEST(NonlinearModes, BilinearOscillatorWithoutClearance) {
  for (const double stiffness : {1.0, 10.0, 100.0}) {
    const double contact = std::sqrt(1 + stiffness);
    const Backbone backbone(
        mode_of(oscillator_on_stop(0, std::make_shared<contact::LinearPenalty>(stiffness)),
                between(0.1, 5)));
    for (const double omega : backbone.omega)
      EXPECT_NEAR(omega, 2 * contact / (1 + contact), 1e-12) << stiffness;
  }
}

/// Of the oscillator with a stop of stiffness K at the distance one: amplitude A of the free arc,
/// u = 1 + y behind the stop, y'' + (1 + K) y = -1.
double period_with_stop(double energy, double stiffness) {
  const double amplitude = std::sqrt(2 * energy);
  if (amplitude <= 1)
    return 2 * pi;
  const double omega = std::sqrt(1 + stiffness), speed = std::sqrt(2 * energy - 1);
  const double rest = 1 / (omega * omega);
  return 2 * (pi - std::acos(1 / amplitude)) +
         2 / omega * (pi / 2 + std::asin(-rest / std::hypot(rest, speed / omega)));
}

TEST(NonlinearModes, BilinearOscillatorWithClearance) {
  for (const double stiffness : {0.5, 10.0, 1000.0}) {
    const PointResult result =
        mode_of(oscillator_on_stop(1, std::make_shared<contact::LinearPenalty>(stiffness)),
                between(0.1, 20));
    const Backbone backbone(result);
    EXPECT_DOUBLE_EQ(backbone.energy.back(), 20);
    for (std::size_t i = 0; i < backbone.energy.size(); ++i)
      EXPECT_NEAR(2 * pi / backbone.omega[i], period_with_stop(backbone.energy[i], stiffness),
                  1e-11)
          << stiffness << " at " << backbone.energy[i];
    EXPECT_NEAR(field_of(result, "special/energy").values.at(0), 0.5, 1e-12);
    EXPECT_EQ(field_of(result, "special/kind").values.at(0), 6);
  }
}

// Backbone pi sqrt(1 + g A^2) / (2 K(m)), m = g A^2 / (2 (1 + g A^2)).
TEST(NonlinearModes, CubicSpringByEllipticIntegrals) {
  for (const double cubic : {0.1, 1.0}) {
    const System system = with_cubic_spring(oscillator(), cubic);
    const Backbone backbone(mode_of(system, between(0.01, 8)));
    for (std::size_t i = 0; i < backbone.energy.size(); ++i) {
      // E = A^2 / 2 + g A^4 / 4
      const double square = (std::sqrt(1 + 4 * cubic * backbone.energy[i]) - 1) / cubic;
      EXPECT_NEAR(backbone.omega[i], backbone_of_cubic_spring(cubic, square), 1e-9)
          << cubic << " at " << backbone.energy[i];
    }
  }
}

std::shared_ptr<const contact::ContactLaw> power_law(double stiffness, double exponent) {
  return std::make_shared<contact::Hertz>(
      contact::HertzConstants{.stiffness = stiffness, .exponent = exponent});
}

// Stops on both sides that touch at rest, of force g u^3: the cubic spring.
TEST(NonlinearModes, TwoStopsOfCubicForceAreACubicSpring) {
  System system = oscillator_on_stop(0, power_law(0.5, 3));
  contact::ContactPair left = system.contacts.pairs()[0];
  left.name = "left";
  left.gap.row *= -1;
  system.contacts = contact::ContactSet({system.contacts.pairs()[0], left});
  const Backbone backbone(mode_of(system, between(0.01, 4)));
  for (std::size_t i = 0; i < backbone.energy.size(); ++i) {
    const double square = (std::sqrt(1 + 2 * backbone.energy[i]) - 1) / 0.5;
    EXPECT_NEAR(backbone.omega[i], backbone_of_cubic_spring(0.5, square), 1e-8)
        << backbone.energy[i];
  }
}

/// Behind a Hertz stop that touches at rest: twice the integral of du / sqrt(2 (E - V)) up to the
/// turn, V = u^2 / 2 + k u^(5/2) / 2.5, over u = turn sin^2 s by Simpson's rule.
double time_behind_hertz_stop(double energy, double stiffness) {
  const auto stored = [&](double u) { return u * u / 2 + stiffness * std::pow(u, 2.5) / 2.5; };
  const double turn =
      zero_between([&](double u) { return stored(u) - energy; }, 0, std::sqrt(2 * energy));
  constexpr int parts = 2000;
  double sum = 2 * turn / std::sqrt(2 * turn * (turn + stiffness * std::pow(turn, 1.5)));
  for (int i = 1; i < parts; ++i) {
    const double s = i * pi / 2 / parts, u = turn * std::sin(s) * std::sin(s);
    sum += (i % 2 != 0 ? 4 : 2) * turn * std::sin(2 * s) / std::sqrt(2 * (energy - stored(u)));
  }
  return 2 * sum * pi / 2 / parts / 3;
}

TEST(NonlinearModes, HertzStopByQuadrature) {
  const Backbone backbone(mode_of(oscillator_on_stop(0, power_law(20, 1.5)), between(0.01, 4)));
  for (std::size_t i = 0; i < backbone.energy.size(); ++i)
    EXPECT_NEAR(2 * pi / backbone.omega[i], pi + time_behind_hertz_stop(backbone.energy[i], 20),
                1e-8)
        << backbone.energy[i];
}

// T = 4 asin(1 / A) between rigid stops on both sides, pi on one that touches at rest.
TEST(NonlinearModes, RigidStops) {
  System between_stops = oscillator_on_stop(1, testing::newton(1));
  contact::ContactPair left = between_stops.contacts.pairs()[0];
  left.name = "left";
  left.gap.row *= -1;
  between_stops.contacts = contact::ContactSet({between_stops.contacts.pairs()[0], left});
  const PointResult both = mode_of(between_stops, between(0.1, 8));
  const Backbone backbone(both);
  EXPECT_DOUBLE_EQ(backbone.energy.back(), 8);
  for (std::size_t i = 0; i < backbone.energy.size(); ++i) {
    const double amplitude = std::sqrt(2 * backbone.energy[i]);
    const double period = amplitude <= 1 ? 2 * pi : 4 * std::asin(1 / amplitude);
    EXPECT_NEAR(2 * pi / backbone.omega[i], period, 1e-10) << backbone.energy[i];
    EXPECT_EQ(field_of(both, "symmetric").values[i], 1);
  }
  const PointResult touching = mode_of(oscillator_on_stop(0, testing::newton(1)), between(0.1, 8));
  for (const double omega : Backbone(touching).omega)
    EXPECT_NEAR(omega, 2, 1e-12);
}

// Two equal masses with cubic springs to the ground, coupled by a linear spring c. In phase each is
// an oscillator x'' + x + g x^3 = 0, x = A cn(W t), k^2 = g A^2 / (2 W^2). Out of phase Lame's
// equation of order two holds, whose periodic solutions are known: sn cn at (1 + 2 c) / W^2 + 6 k^2
// = 4 + k^2, another one at 2 (1 + k^2) + 2 sqrt(1 - k^2 + k^4). Both repeat after half a period,
// so that there the motion in phase loses its symmetry.
TEST(NonlinearModes, SymmetryIsLostAtTheEdgesOfLamesEquation) {
  const double coupling = 2;
  System system = testing::system_of(
      model::Model({testing::single_mass("a", 1, 1, 0), testing::single_mass("b", 1, 1, 0)}));
  const model::PointReference a{.body = 0}, b{.body = 1};
  const model::Projection first = system.model.displacement(a, Vector3::UnitX(), false);
  const model::Projection second = system.model.displacement(b, Vector3::UnitX(), false);
  model::Projection between_them = second;
  between_them.row -= first.row;
  system.model.add_connection({.name = "first",
                               .side_a = "a.head",
                               .side_b = "ground",
                               .elongation = first,
                               .cubic_stiffness = 1});
  system.model.add_connection({.name = "second",
                               .side_a = "b.head",
                               .side_b = "ground",
                               .elongation = second,
                               .cubic_stiffness = 1});
  system.model.add_connection({.name = "coupling",
                               .side_a = "a.head",
                               .side_b = "b.head",
                               .elongation = between_them,
                               .stiffness = coupling});
  NonlinearMode::Settings settings = between(0.01, 1);
  settings.continuation.longest_step = 0.03;
  const PointResult result = mode_of(system, settings);
  const auto energy = [](double square) { // of k^2
    const double amplitude = 2 * square / (1 - 2 * square);
    return amplitude + amplitude * amplitude / 2;
  };
  const std::vector<double> edges = {energy((32 - std::sqrt(384)) / 64), energy(0.2)};
  const std::vector<double> &kinds = field_of(result, "special/kind").values;
  ASSERT_EQ(kinds.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(kinds[i], 4); // loss of symmetry
    EXPECT_NEAR(field_of(result, "special/energy").values[i], edges[i], 1e-8);
  }
  const std::vector<double> &along = field_of(result, "energy").values;
  const std::vector<double> &stable = field_of(result, "stable").values;
  for (std::size_t i = 0; i < along.size(); ++i)
    EXPECT_EQ(stable[i], along[i] < edges[0] || along[i] > edges[1] ? 1 : 0) << along[i];
}

/// One impact a period of a system with modes phi at the contact on a rigid stop at the distance
/// one: a_i = phi_i p / (2 w_i sin(w_i T / 2)), gap 1 = p / 2 sum(phi_i^2 cot(w_i T / 2) / w_i).
struct ImpactMotion {
  double energy = 0, impact_speed = 0;
  ImpactMotion(double omega, const Vector &frequencies, const Vector &shape) {
    const double half = pi / omega;
    const auto w = frequencies.array();
    const double jump = 2 / (shape.array().square() / (w * (w * half).tan())).sum();
    const auto amplitude = shape.array() * jump / (2 * w * (w * half).sin());
    energy = 0.5 * (amplitude * w).square().sum();
    impact_speed = jump * shape.squaredNorm() / 2;
  }
};

TEST(NonlinearModes, TwoMassesOnARigidStop) {
  System system = two_masses();
  system.contacts = contact::ContactSet(
      {testing::contact_along_x(system.model, "b.head", "", 1, testing::newton(1))});
  const PointResult result = mode_of(system, between(0.1, 2.2));
  const Backbone backbone(result);
  EXPECT_DOUBLE_EQ(backbone.energy.back(), 2.2);
  const double golden = (std::sqrt(5) - 1) / 2;
  const Vector frequencies = testing::vector_of({golden, 1 + golden});
  const double slow = 1 / std::hypot(1, 1 + golden), fast = 1 / std::hypot(1, golden);
  const Vector shape = testing::vector_of({(1 + golden) * slow, golden * fast});
  const double grazing = std::pow(golden / shape[0], 2) / 2;
  EXPECT_NEAR(grazing, 0.2639320225, 1e-10);
  EXPECT_NEAR(ImpactMotion(0.9, frequencies, shape).energy, 0.896426367227, 1e-12);
  for (std::size_t i = 0; i < backbone.energy.size(); ++i) {
    if (backbone.energy[i] <= grazing)
      EXPECT_NEAR(backbone.omega[i], golden, 1e-12);
    else
      EXPECT_NEAR(ImpactMotion(backbone.omega[i], frequencies, shape).energy, backbone.energy[i],
                  1e-9 * backbone.energy[i])
          << backbone.omega[i];
  }
}

TEST(NonlinearModes, ResumedModesAreTheSame) {
  for (const periodic::Losses losses : {periodic::Losses::none, periodic::Losses::balanced}) {
    NonlinearMode::Settings settings = between(0.1, 1);
    settings.losses = losses;
    settings.levels = 1;
    const NonlinearMode mode(settings);
    System system = two_masses(losses == periodic::Losses::none ? 0 : 0.02);
    system.contacts = contact::ContactSet(
        {testing::contact_along_x(system.model, "b.head", "", 1, testing::newton(1))});
    ModePoint whole;
    mode.run_line(0, system, whole);
    ASSERT_EQ(whole.result.status, Status::finished) << whole.result.reason;
    ASSERT_GT(whole.fresh.size(), 20U);
    for (const std::size_t kept : {std::size_t{1}, std::size_t{9}, whole.fresh.size() - 4}) {
      ModePoint resumed;
      resumed.known = testing::first_of(whole.fresh, kept);
      mode.run_line(0, system, resumed);
      for (const Field &field : whole.result.fields) {
        const std::vector<double> &again = field_of(resumed.result, field.name()).values;
        ASSERT_EQ(again.size(), field.values.size());
        EXPECT_EQ(std::memcmp(again.data(), field.values.data(), 8 * again.size()), 0)
            << field.name() << " from step " << kept;
      }
    }
  }
}

} // namespace nonlinear_modes_tests
} // namespace vibroimpact::analyses
