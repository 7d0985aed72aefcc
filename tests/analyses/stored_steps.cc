// Steps towards a point on their way to the sink and back.
#include "analyses/run/stored_steps.h"

#include "common/signals.h"

#include <gtest/gtest.h>

#include <map>

namespace vibroimpact::analyses {
namespace stored_steps_tests {

using Index = std::vector<std::size_t>;

class StepSink : public ResultSink {
public:
  void begin(const AnalysisHeader & /*header*/) override {}
  const PointResult *find(const Index & /*index*/) const override { return nullptr; }
  void store(const PointResult & /*result*/) override {}
  void end() override {}
  std::vector<std::string> find_steps(const Index &index) const override {
    const auto found = kept.find(index);
    return found == kept.end() ? std::vector<std::string>() : found->second;
  }
  void store_steps(const Index &index, std::size_t first,
                   const std::vector<std::string> &steps) override {
    EXPECT_EQ(first, kept[index].size());
    kept[index].insert(kept[index].end(), steps.begin(), steps.end());
    ++bundles;
  }

  std::map<Index, std::vector<std::string>> kept;
  int bundles = 0;
};

/// Stands still but for what a test sets.
struct HandClock {
  std::chrono::milliseconds elapsed{0};
  std::function<StoredSteps::Clock::time_point()> now() const {
    return [this] { return StoredSteps::Clock::time_point(elapsed); };
  }
};

TEST(StoredStepsTest, WhatAnExceptionLeavesIsGoneOnFrom) {
  const HandClock time;
  StepSink sink;
  RunSummary summary;
  try {
    StoredSteps steps(sink, {2}, summary, time.now());
    EXPECT_FALSE(steps.next());
    for (const char *step : {"a", "b"})
      steps.keep(step);
    throw Interrupted{};
  } catch (const Interrupted &) {
  }
  EXPECT_EQ(sink.bundles, 1);
  try {
    StoredSteps steps(sink, {2}, summary, time.now());
    EXPECT_EQ(steps.next(), "a");
    EXPECT_EQ(steps.next(), "b");
    EXPECT_FALSE(steps.next());
    steps.keep("c");
    throw Interrupted{};
  } catch (const Interrupted &) {
  }
  EXPECT_EQ(sink.kept.at({2}), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(summary.steps_taken_over, 2U);
  EXPECT_EQ(summary.steps_computed, 3U);
  EXPECT_FALSE(StoredSteps(sink, {3}, summary).next());
}

TEST(StoredStepsTest, OfAPointThatIsReachedSoonNothingIsStored) {
  StepSink sink;
  RunSummary summary;
  {
    const HandClock time;
    StoredSteps steps(sink, {}, summary, time.now());
    steps.keep("a");
  }
  EXPECT_EQ(sink.bundles, 0);
}

// A kill takes only what came since.
TEST(StoredStepsTest, AreHandedOverAfterATenthOfASecond) {
  StepSink sink;
  RunSummary summary;
  HandClock time;
  StoredSteps steps(sink, {}, summary, time.now());
  steps.keep("a");
  time.elapsed = std::chrono::milliseconds(110);
  steps.keep("b");
  EXPECT_EQ(sink.kept.at({}), (std::vector<std::string>{"a", "b"}));
}

} // namespace stored_steps_tests
} // namespace vibroimpact::analyses
