// Small perturbations of motions in steps that no contact change ends: multipliers, Lyapunov
// exponents and a branch of a beam on 16 stops, against the exact method and differences.
#include "continuation/branch.h"
#include "family.h"
#include "support/beam_on_stops.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace moment_orbits_tests {

using testing::BeamOnStops;
using testing::Family;
using testing::Oscillator;
using testing::StopLaw;

constexpr double period = 0.25;

BeamOnStops beam(const StopLaw &law, double push = 3) {
  return {.modes = 3, .stops = 16, .law = law.make(16), .push = push};
}

motion::Settings settings_of(const std::string &method) {
  return {.method = method,
          .relative_tolerance = method == "exact" ? 1e-12 : 1e-10,
          .event_tolerance = 1e-14};
}

/// The motion that the beam settles to, by one method.
struct Settled {
  Settled(const BeamOnStops &of, const std::string &method)
      : model(of.model()), contacts(of.contacts(model)),
        system(model, contacts, settings_of(method), 0), scale(2 * of.modes) {
    scale << of.body()->stiffness.cwiseSqrt(), Vector::Ones(of.modes);
    motion::Trajectory &trajectory = system.trajectory();
    trajectory.start(0, Vector::Zero(model.size()), Vector::Zero(model.size()));
    trajectory.advance(40 * period);
    map = std::make_unique<StroboscopicMap>(system, accuracy());
    orbit = find_orbit(*map, 1, trajectory.motion_state().physical);
    state = state_at_zero_phase(*map, orbit);
    multipliers = orbit.multipliers(*map);
  }
  motion::VariationAccuracy accuracy() const { return {.scale = scale, .tolerance = 1e-12}; }
  motion::LinearisedMotion linearised(const Vector &start) {
    return motion::Lineariser(system.trajectory(), accuracy())({.time = 0, .physical = start},
                                                               period);
  }
  Matrix scaled(const Matrix &by_state) const {
    return scale.asDiagonal() * by_state * scale.cwiseInverse().asDiagonal();
  }

  model::Model model;
  contact::ContactSet contacts;
  ForcedSystem system;
  Vector scale; ///< to the energy norm
  std::unique_ptr<StroboscopicMap> map;
  Orbit orbit;
  Vector state; ///< at the start of a period
  Eigen::VectorXcd multipliers;
};

// Instants of contact changes are right to the square of what the gap's polynomial misses, and
// deviations pass phases and changes as they do elsewhere: multipliers are as exact as the state.
// Where contacts are nonlinear, deviations are integrated beside a motion that begins anew at each
// part: 1e-7.
TEST(MomentOrbitsTest, MultipliersAreThoseOfTheExactMethod) {
  for (const StopLaw &law : testing::stop_laws()) {
    SCOPED_TRACE(law.name);
    const BeamOnStops system = beam(law);
    Settled exact(system, "exact"), found(system, "moments");
    const double tolerance = law.linear ? 2e-9 : 1e-7;
    EXPECT_GT(found.system.trajectory().accuracy().moment_steps, 0);
    EXPECT_GE(found.orbit.point.image.pattern.events.size(), 32u);
    EXPECT_LT((found.scale.cwiseProduct(found.state - exact.state)).norm(),
              1e-9 * exact.scale.cwiseProduct(exact.state).norm());
    EXPECT_LT((found.multipliers - exact.multipliers).norm(), tolerance);
    const motion::LinearisedMotion linearised = found.linearised(exact.state);
    const Matrix expected = exact.scaled(exact.linearised(exact.state).by_state);
    EXPECT_LT((found.scaled(linearised.by_state) - expected).norm(), tolerance * expected.norm());
    EXPECT_NEAR(linearised.determinant.value() / linearised.by_state.determinant(), 1, 1e-8);
    EXPECT_EQ(linearised.without_derivative, 0);
  }
}

// Of order 4; the powers 3/2 of sixteen touches leave 1e-6 of them.
TEST(MomentOrbitsTest, DerivativesAreDifferences) {
  const StopLaw hertz = testing::stop_laws()[2];
  Settled found(beam(hertz), "moments");
  motion::Trajectory trajectory(found.model, found.contacts, settings_of("exact"));
  const auto end = [&](const Vector &start) -> Vector {
    trajectory.start({.time = 0, .physical = start});
    trajectory.advance(period);
    return trajectory.motion_state().physical;
  };
  Matrix differences(6, 6);
  for (Index j = 0; j < 6; ++j) {
    const Vector step =
        Vector::Unit(6, j) * 2e-6 * found.scale.cwiseProduct(found.state).norm() / found.scale[j];
    const Vector &at = found.state;
    differences.col(j) =
        (8 * (end(at + step) - end(at - step)) - (end(at + 2 * step) - end(at - 2 * step))) / 12 /
        step[j];
  }
  const Matrix expected = found.scaled(differences);
  EXPECT_LT((found.scaled(found.linearised(found.state).by_state) - expected).norm(),
            2e-6 * expected.norm());
}

// On a periodic motion the mean growth of deviations is the logarithm of the multipliers over the
// period.
TEST(MomentOrbitsTest, LyapunovExponentsAreThoseOfTheMultipliers) {
  Settled found(beam(testing::stop_laws()[0]), "moments");
  motion::Trajectory &trajectory = found.system.trajectory();
  trajectory.start({.time = 0, .physical = found.state});
  motion::Variation variation(trajectory, found.scale, 1e-12);
  variation.set_columns(found.scale.cwiseInverse().asDiagonal() * Matrix::Identity(6, 6));
  const int discarded = 30, periods = 130;
  Vector growth = Vector::Zero(6);
  for (int k = 1; k <= periods; ++k) {
    trajectory.advance(k * period, variation);
    const Vector now = variation.orthonormalise();
    if (k > discarded)
      growth += now / (periods - discarded);
  }
  for (Index k = 0; k < 4; ++k) // of a pair the mean turns with its phase
    EXPECT_NEAR(growth[k], std::log(std::abs(found.multipliers[k])), 0.01) << k;
  EXPECT_NEAR(growth.sum(), found.multipliers.cwiseAbs().array().log().sum(), 1e-7);
}

// Along the amplitude of the force.
TEST(MomentOrbitsTest, ABranchEndsWhereTheExactMotionIs) {
  const StopLaw linear = testing::stop_laws()[0];
  const double from = 3, to = 3.2;
  Family family(
      [&](double push) {
        const BeamOnStops system = beam(linear, push);
        Oscillator made{.model = system.model(), .settings = settings_of("moments")};
        made.contacts = system.contacts(made.model);
        return made;
      },
      false);
  const Settled start(beam(linear, from), "exact");
  const Orbit orbit = find_orbit(family.at(from), 1, start.state);
  OrbitProblem problem(family, 2,
                       problem_sizes(family.at(from), orbit, Vector::Constant(1, to - from)));
  continuation::Settings settings;
  settings.first_key = {.lower = from - 0.1, .upper = to};
  settings.longest_step = 0.2;
  const continuation::Branch branch =
      continuation::follow(problem,
                           {.point = {.state = orbit.point.state,
                                      .keys = Vector::Constant(1, from),
                                      .chart = orbit.section.phase},
                            .direction = {}},
                           settings);
  EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
  const continuation::BranchPoint &last = branch.points.back();
  EXPECT_EQ(last.point.keys[0], to);
  Settled exact(beam(linear, to), "exact");
  ASSERT_EQ(last.multipliers.size(), 6u);
  for (Index k = 0; k < 6; ++k)
    EXPECT_NEAR(std::abs(last.multipliers[static_cast<std::size_t>(k)]),
                std::abs(exact.multipliers[k]), 1e-8);
}

} // namespace moment_orbits_tests
} // namespace vibroimpact::periodic
