// The share of curves that is done, from where their key is.
#include "analyses/curves/curve_progress.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace curve_progress_tests {

TEST(CurveProgressTest, GoesByTheKeyAndNeverBack) {
  CurveProgress progress({.lower = 0, .upper = 10});
  progress.begin(4);
  EXPECT_DOUBLE_EQ(progress.at(7, 2), 0.25);
  EXPECT_DOUBLE_EQ(progress.at(5, 2), 0.25); // behind a fold
  EXPECT_DOUBLE_EQ(progress.at(10, 2), 0.5);
  progress.finish();
  progress.begin(4);
  EXPECT_DOUBLE_EQ(progress.at(2, 1), 0.75);
  EXPECT_DOUBLE_EQ(progress.at(0, 1), 1);
}

TEST(CurveProgressTest, OfMoreCurvesThanWereKnown) {
  CurveProgress progress({.lower = 0, .upper = 10});
  progress.begin(0);
  EXPECT_DOUBLE_EQ(progress.at(5, 1), 0.5);
  EXPECT_DOUBLE_EQ(progress.at(6, 4), 0.5); // three branches begin here
  EXPECT_DOUBLE_EQ(progress.at(10, 1), 1);
}

} // namespace curve_progress_tests
} // namespace vibroimpact::analyses
