#include "common/work_limit.h"

#include "common/signals.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace work_limit_tests {

// Processor time passes, nothing else.
void compute_until(double end) {
  volatile double sink = 0;
  while (processor_seconds() < end && !stop_requested())
    for (int i = 0; i < 1000; ++i)
      sink = sink + 1;
}

TEST(WorkLimits, AskTheComputationToStop) {
  const double start = processor_seconds();
  {
    const WorkLimit limit(0.05);
    EXPECT_FALSE(stop_requested());
    compute_until(start + 100);
    EXPECT_TRUE(limit.reached());
    EXPECT_THROW(leave_if_stopped(), Interrupted);
  }
  EXPECT_GE(processor_seconds() - start, 0.04);
  EXPECT_FALSE(stop_requested());
}

TEST(WorkLimits, AreOverWhenTheyGo) {
  { const WorkLimit limit(0.02); }
  const double start = processor_seconds();
  compute_until(start + 0.06);
  EXPECT_GE(processor_seconds() - start, 0.06);
}

TEST(WorkLimits, CanEndTheProcess) {
  EXPECT_EXIT(
      {
        const EndAtLimit limit(0.02, "long enough", true);
        compute_until(processor_seconds() + 100);
      },
      ::testing::ExitedWithCode(0), "");
}

} // namespace work_limit_tests
} // namespace vibroimpact
