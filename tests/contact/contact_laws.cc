// Each law at hand-computed states, its derivatives against differences, its energies against work.
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"
#include "contact/restitution_relation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::contact {
namespace contact_laws_tests {

constexpr HertzConstants constants{.stiffness = 2e9, .exponent = 1.5};

std::vector<std::shared_ptr<const ContactLaw>> all_laws() {
  return {std::make_shared<LinearPenalty>(3e6), std::make_shared<Hertz>(constants),
          HuntCrossley::with_dissipation(constants, 0.8),
          HuntCrossley::with_dimensionless_damping(constants, 0.6, 1e-6)};
}

LawResponse evaluate(const ContactLaw &law, int mode, double gap, double rate,
                     const std::vector<double> &internal) {
  LawResponse response;
  law.evaluate(mode, {.gap = gap, .gap_rate = rate, .internal = internal}, response);
  return response;
}

TEST(ContactLawsTest, LinearPenaltyPushesWithItsSpring) {
  const LinearPenalty law(3e6);
  EXPECT_DOUBLE_EQ(evaluate(law, 1, -2e-4, 0.3, {}).force, 600);
  EXPECT_DOUBLE_EQ(evaluate(law, 1, -2e-4, 0.3, {}).stored_energy, 0.06);
  EXPECT_EQ(evaluate(law, 0, -2e-4, 0.3, {}).force, 0);
}

// Two steel spheres of 15 mm, and a sphere on a plane; figures worked out by hand:
// E* = 206e9 / (2 (1 - 0.09)) = 113.1868e9 Pa, R* = 7.5 mm and 15 mm.
TEST(ContactLawsTest, HertzStiffnessFromGeometryAndMaterial) {
  const HertzSide sphere{.curvature = 1 / 0.015, .young_modulus = 206e9, .poisson_ratio = 0.3};
  const HertzSide plane{.curvature = 0, .young_modulus = 206e9, .poisson_ratio = 0.3};
  EXPECT_NEAR(hertz_stiffness(sphere, sphere), 1.30696874e10, 1e2);
  EXPECT_NEAR(hertz_stiffness(sphere, plane), 1.8483e10, 1e6);
  EXPECT_THROW(hertz_stiffness(plane, plane), std::invalid_argument);
}

TEST(ContactLawsTest, HertzForceFollowsThePower) {
  const Hertz law(constants);
  EXPECT_NEAR(evaluate(law, 1, -1e-4, 0, {}).force, 2e9 * 1e-6, 1e-9);
  EXPECT_NEAR(evaluate(law, 1, -1e-4, 0, {}).stored_energy, 2e9 * 1e-10 / 2.5, 1e-12);
  EXPECT_EQ(evaluate(law, 1, 1e-9, -1, {}).force, 0);
}

TEST(ContactLawsTest, HuntCrossleyResistsApproachAndNeverPulls) {
  const auto law = HuntCrossley::with_dissipation(constants, 0.8);
  const double elastic = 2e3;
  EXPECT_NEAR(evaluate(*law, 1, -1e-4, -0.5, {}).force, elastic * 1.4, 1e-9);
  EXPECT_NEAR(evaluate(*law, 1, -1e-4, 0.5, {}).force, elastic * 0.6, 1e-9);
  // Separating faster than 1/d = 1.25 m/s would be tension: guarded by its own mode.
  const Guard &guard = law->modes()[1].guards[1];
  EXPECT_GT(guard.indicator({.gap = -1e-4, .gap_rate = 1.2}), 0);
  EXPECT_LT(guard.indicator({.gap = -1e-4, .gap_rate = 1.3}), 0);
  EXPECT_EQ(law->modes()[guard.target].name, "separating");
  EXPECT_EQ(evaluate(*law, guard.target, -1e-4, 1.3, {}).force, 0);
}

TEST(ContactLawsTest, ApproachSpeedIsRememberedAtOnset) {
  const auto law = HuntCrossley::with_dimensionless_damping(constants, 0.6, 1e-6);
  ASSERT_EQ(law->n_internal(), 1);
  const Guard &closing = law->modes()[0].guards[0];
  const std::vector<double> before = {7.0};
  EXPECT_EQ(closing.reset[0]({.gap = 0, .gap_rate = -0.4, .internal = before}), 0.4);
  EXPECT_NEAR(evaluate(*law, 1, -1e-4, -0.4, {0.4}).force, 2e3 * 1.6, 1e-9);
  // Below the lowest speed the dissipation stays bounded.
  EXPECT_NEAR(evaluate(*law, 1, -1e-4, -1e-6, {0.0}).force, 2e3 * 1.6, 1e-9);
}

TEST(ContactLawsTest, DerivativesAgreeWithDifferences) {
  for (const auto &law : all_laws())
    for (int mode = 0; mode < static_cast<int>(law->modes().size()); ++mode)
      for (const double rate : {-0.3, 0.4}) {
        const double gap = -3e-5;
        const std::vector<double> internal(law->n_internal(), 0.5);
        const double h = 1e-9;
        const LawResponse at = evaluate(*law, mode, gap, rate, internal);
        const double by_gap = (evaluate(*law, mode, gap + h, rate, internal).force -
                               evaluate(*law, mode, gap - h, rate, internal).force) /
                              (2 * h);
        const double by_rate = (evaluate(*law, mode, gap, rate + 1e-5, internal).force -
                                evaluate(*law, mode, gap, rate - 1e-5, internal).force) /
                               2e-5;
        EXPECT_NEAR(at.force_by_gap, by_gap, 1e-5 * std::abs(by_gap) + 1e-3) << law->name();
        EXPECT_NEAR(at.force_by_gap_rate, by_rate, 1e-6 * std::abs(by_rate) + 1e-6) << law->name();
        for (int i = 0; i < law->n_internal(); ++i) {
          std::vector<double> up = internal;
          std::vector<double> down = internal;
          up[i] += 1e-5;
          down[i] -= 1e-5;
          const double by_internal = (evaluate(*law, mode, gap, rate, up).force -
                                      evaluate(*law, mode, gap, rate, down).force) /
                                     2e-5;
          EXPECT_NEAR(at.force_by_internal[i], by_internal, 1e-6 * std::abs(by_internal) + 1e-6)
              << law->name();
        }
      }
}

// Power balance in every mode: what the force takes from the motion is stored or dissipated.
TEST(ContactLawsTest, WorkIsStoredOrDissipated) {
  for (const auto &law : all_laws())
    for (int mode = 1; mode < static_cast<int>(law->modes().size()); ++mode)
      for (const double rate : {-0.3, 0.4}) {
        const double gap = -3e-5;
        const double h = 1e-10;
        const std::vector<double> internal(law->n_internal(), 0.5);
        const LawResponse at = evaluate(*law, mode, gap, rate, internal);
        const double stored_rate = (evaluate(*law, mode, gap + h, rate, internal).stored_energy -
                                    evaluate(*law, mode, gap - h, rate, internal).stored_energy) /
                                   (2 * h) * rate;
        EXPECT_NEAR(-at.force * rate, stored_rate + at.dissipated_power,
                    1e-5 * std::abs(stored_rate))
            << law->name();
        if (at.force > 0) {
          EXPECT_GE(at.dissipated_power, 0) << law->name();
        }
      }
}

TEST(ContactLawsTest, AffineModesSayWhatEvaluateDoes) {
  for (const auto &law : all_laws())
    for (int mode = 0; mode < static_cast<int>(law->modes().size()); ++mode) {
      const auto &affine = law->modes()[static_cast<std::size_t>(mode)].affine;
      if (!affine)
        continue;
      const std::vector<double> internal(law->n_internal(), 0.5);
      const LocalState state{.gap = -3e-5, .gap_rate = 0.2, .internal = internal};
      EXPECT_DOUBLE_EQ(affine->force(state),
                       evaluate(*law, mode, state.gap, state.gap_rate, internal).force);
    }
}

} // namespace contact_laws_tests
} // namespace vibroimpact::contact
