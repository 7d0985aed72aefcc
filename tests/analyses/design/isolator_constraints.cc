// Conditions on a stop against published values, and each limit against what it stands for.
#include "analyses/isolators/isolator_constraints.h"
#include "analyses/isolators/isolator_averaging.h"
#include "common/error.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace isolator_constraints_tests {

constexpr IsolatorDamping damping{.isolator = 0.01, .stop = 0.2};

StopConditions published() {
  return {.damping = damping, .unfolding_ratio = 1, .working_ratio = 2.75, .allowed = 1.2 / 0.52};
}

TEST(IsolatorConstraintsTest, TransmissibilityIsThatOfTheLinearIsolator) {
  EXPECT_NEAR(transmissibility(1, 0.5), std::sqrt(2), 1e-15); // |1 + i|/|i|
  EXPECT_NEAR(transmissibility(std::sqrt(2), 0.37), 1, 1e-15);
  for (const double zeta : {0.0, 0.01, 0.4})
    for (const double t : {0.05, 0.3, 0.9})
      EXPECT_NEAR(transmissibility(ratio_for_transmissibility(t, zeta), zeta), t, 1e-13);
  EXPECT_NEAR(ratio_for_transmissibility(0.2, 0), undamped_ratio_for_transmissibility(0.2), 1e-14);
  EXPECT_NEAR(undamped_ratio_for_transmissibility(0.125), 3, 1e-15);
}

TEST(IsolatorConstraintsTest, LargestLinearForceIsThePublishedOne) {
  EXPECT_NEAR(largest_linear_force(2.75, 0.01), 6.5627305, 5e-8);
  EXPECT_NEAR(published().largest_force(), 6.5627305, 5e-8);
}

TEST(IsolatorConstraintsTest, TheCornerOfResonanceAndJumpIsThePublishedOne) {
  const StopChoice corner = corners_of(published()).resonance_and_jump;
  EXPECT_NEAR(corner.force, 1.75952, 5e-6);
  EXPECT_NEAR(corner.stiffness, 1.69256, 5e-6);
  const UnfoldingParameters at = unfolding_of(corner, damping, 1);
  EXPECT_NEAR(at.first, 0.19489, 5e-6);
  EXPECT_NEAR(at.second, -0.61077, 5e-6);
}

TEST(IsolatorConstraintsTest, AtTheClearanceOfTheFileNoStopMeetsBoth) {
  EXPECT_NEAR(published().least_stiffness(0.52), 865, 0.5);
  EXPECT_NEAR(published().largest_stiffness(0.52), 0.62, 0.005);
}

TEST(IsolatorConstraintsTest, EveryCornerLiesOnItsTwoLimits) {
  StopConditions conditions = published();
  conditions.margin = 0.1;
  const StopCorners corners = corners_of(conditions);
  const auto peak = [&](const StopChoice &stop, double stiffness) {
    return AveragedResponse(damping, {.stiffness = stiffness, .force = stop.force})
        .peak()
        .amplitude;
  };
  const auto on_set = [&](const StopChoice &stop) { // with its margin
    const auto at = unfolding_of({1.1 * stop.stiffness, stop.force}, damping, 1);
    return at.second - hysteresis_above(at.first, damping.rho()).at.second;
  };
  const StopChoice &bc = corners.resonance_and_jump, &ab = corners.linear_and_resonance,
                   &ac = corners.linear_and_jump;
  EXPECT_NEAR(peak(bc, bc.stiffness / 1.1) / bc.force, 1.2 / 0.52, 1e-9);
  EXPECT_NEAR(on_set(bc), 0, 1e-9);
  EXPECT_NEAR(ab.force * 1.1, 6.5627305, 5e-8);
  EXPECT_NEAR(peak(ab, ab.stiffness / 1.1) / ab.force, 1.2 / 0.52, 1e-9);
  EXPECT_NEAR(ac.force * 1.1, 6.5627305, 5e-8);
  EXPECT_NEAR(on_set(ac), 0, 1e-9);
}

// Inside the set the resonance is below what is allowed and does not jump; beyond its corner with
// the largest clearance one of the two fails.
TEST(IsolatorConstraintsTest, ThePreferredStopMeetsAllConditions) {
  StopConditions conditions = published();
  conditions.margin = 0.05;
  const StopCorners corners = corners_of(conditions);
  for (const Preference preference : {Preference::least_stiffness, Preference::largest_clearance}) {
    const StopChoice stop = preferred_stop(conditions, corners, preference);
    const AveragedResponse response(damping, stop);
    EXPECT_LT(response.peak().amplitude, conditions.allowed * stop.force);
    EXPECT_TRUE(response.folds().empty());
    EXPECT_EQ(region_of(unfolding_of(stop, damping, 1), damping.rho()), Region::four);
    EXPECT_LT(stop.force, 6.5627305);
  }
  EXPECT_LT(preferred_stop(conditions, corners, Preference::least_stiffness).stiffness,
            preferred_stop(conditions, corners, Preference::largest_clearance).stiffness);
}

// The hysteresis set with lambda = 1 is on the safe side: the averaged response itself allows a
// larger clearance, and folds just beyond its corner.
TEST(IsolatorConstraintsTest, TheAveragedResponseAllowsALargerClearance) {
  StopConditions averaged = published();
  averaged.jump_limit = JumpLimit::averaged_response;
  const StopChoice corner = corners_of(averaged).resonance_and_jump;
  EXPECT_LT(corner.force, 1.7);
  const auto folds = [&](double factor) {
    return AveragedResponse(damping, {factor * corner.stiffness, corner.force}).folds().size();
  };
  EXPECT_EQ(folds(0.999), 0);
  EXPECT_EQ(folds(1.001), 2);
  EXPECT_NEAR(AveragedResponse(damping, corner).peak().amplitude / corner.force, averaged.allowed,
              1e-9);
}

std::string refusal(const StopConditions &conditions) {
  try {
    preferred_stop(conditions, corners_of(conditions), Preference::least_stiffness);
  } catch (const NumericalError &error) {
    return error.what();
  }
  return "";
}

TEST(IsolatorConstraintsTest, ConditionsThatNoStopMeetsAreRefused) {
  StopConditions tight = published();
  tight.working_ratio = 1.5; // f <= 1.25, below the corner
  EXPECT_TRUE(std::isnan(corners_of(tight).resonance_and_jump.force));
  EXPECT_NE(refusal(tight).find("no stop meets all conditions"), std::string::npos);
  StopConditions loose = published();
  loose.allowed = 50.01; // the isolator alone: 1/(2 zeta_0 sqrt(1 - zeta_0^2)) = 50.0025
  EXPECT_NE(refusal(loose).find("no stop is needed"), std::string::npos);
  loose.allowed = 49.99; // at f_max the dashpot does it
  EXPECT_NE(refusal(loose).find("no least stiffness"), std::string::npos);
}

TEST(IsolatorConstraintsTest, TheMarginCountsForTheAveragedResponseToo) {
  StopConditions averaged = published();
  averaged.jump_limit = JumpLimit::averaged_response;
  averaged.margin = 0.1;
  const StopChoice corner = corners_of(averaged).linear_and_jump;
  const auto folds = [&](double factor) {
    return AveragedResponse(damping, {factor * corner.stiffness, corner.force}).folds().size();
  };
  EXPECT_EQ(folds(1.099), 0);
  EXPECT_EQ(folds(1.101), 2);
}

} // namespace isolator_constraints_tests
} // namespace vibroimpact::analyses
