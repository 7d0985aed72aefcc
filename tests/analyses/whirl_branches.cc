// The speeds at which whirls begin to grow, against closed forms.
#include "analyses/transient/whirl_branches.h"

#include "support/jeffcott.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace whirl_branches_tests {

using testing::Jeffcott;

std::vector<WhirlSpeed> thresholds_of(const model::Model &model, std::vector<double> speeds) {
  const model::AssembledSystem system(model);
  const model::WhirlingSystem whirling(model, system, 0);
  return WhirlBranches(whirling, std::move(speeds), 2).thresholds();
}

// W = w (1 + c_e / c_i), whichever speed the model has, and also where a speed is just this one.
TEST(WhirlBranchesTest, ThresholdOfAJeffcottShaft) {
  const Jeffcott shaft;
  for (const double present : {0.0, 60.0, -35.0}) {
    const model::Model model = shaft.model(model::SpinSpeed(present));
    for (const std::vector<double> &speeds :
         {std::vector<double>{0, 20, 70, 90}, std::vector<double>{0, shaft.threshold(), 90}}) {
      const std::vector<WhirlSpeed> found = thresholds_of(model, speeds);
      ASSERT_EQ(found.size(), 1u) << present;
      EXPECT_NEAR(found[0].speed, shaft.threshold(), 1e-11 * shaft.threshold()) << present;
      EXPECT_NEAR(found[0].state.eigenvalue.imag(), shaft.natural(), 1e-11 * shaft.natural());
    }
    // Against the axis the other whirl grows.
    const std::vector<WhirlSpeed> both = thresholds_of(model, {-90, -5, 5, 90});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NEAR(both[0].speed * both[1].speed, -shaft.threshold() * shaft.threshold(), 1e-7);
  }
}

// What has no losses neither grows nor decays.
TEST(WhirlBranchesTest, NoThresholdWithoutLosses) {
  const Jeffcott shaft{.external = 0, .retardation = 0};
  EXPECT_TRUE(thresholds_of(shaft.model(model::SpinSpeed(10)), {0, 10, 20, 50}).empty());
}

} // namespace whirl_branches_tests
} // namespace vibroimpact::analyses
