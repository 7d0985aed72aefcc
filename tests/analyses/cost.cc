// Estimates of cost of analyses made by hand, whose points take a known processor time. Both sides
// read the same clock, so that a busy machine changes nothing.
#include "analyses/run/cost.h"

#include "analyses/results/fields.h"
#include "common/work_limit.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <set>

namespace vibroimpact::analyses {
namespace cost_tests {

void compute_for(double seconds) {
  const double end = processor_seconds() + seconds;
  volatile double sink = 0;
  while (processor_seconds() < end)
    for (int i = 0; i < 1000; ++i)
      sink = sink + 1;
}

/// A line of `steps` points: each takes some time; the first, or one behind a gap, ten times that.
class Steps : public Analysis {
public:
  explicit Steps(std::size_t steps, double seconds, std::string reason = "")
      : steps_(steps), seconds_(seconds), reason_(std::move(reason)) {}

  std::string type() const override { return "steps"; }
  std::vector<Axis> axes() const override {
    return {{.name = "step",
             .values = std::vector<double>(steps_),
             .labels = {},
             .unit = "1",
             .description = ""}};
  }
  void check(const System & /*system*/) const override {}
  void run_line(std::size_t /*line*/, System & /*system*/, LineContext &context) const override {
    bool carried = false;
    for (std::size_t i = 0; i < steps_; ++i) {
      if (context.find({i})) {
        carried = false;
        continue;
      }
      compute_for(carried ? seconds_ : 10 * seconds_);
      carried = true;
      tried.insert(i);
      context.store({.index = {i},
                     .status = reason_.empty() ? Status::finished : Status::failed,
                     .reason = reason_,
                     .fields = {{.label = Label("numbers", "1", "", {"number"}),
                                 .shape = {100},
                                 .values = std::vector<double>(100)}}});
    }
  }

  mutable std::set<std::size_t> tried;

private:
  std::size_t steps_;
  double seconds_;
  std::string reason_;
};

/// One motion that takes `seconds`, and notes its progress, or only that it goes on.
class Motion : public Analysis {
public:
  explicit Motion(double seconds, bool says_share = true)
      : seconds_(seconds), says_share_(says_share) {}

  std::string type() const override { return "motion"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System & /*system*/) const override {}
  void run_line(std::size_t /*line*/, System & /*system*/, LineContext &context) const override {
    const double start = processor_seconds();
    for (double share = 0; share < 1; share = (processor_seconds() - start) / seconds_)
      context.note_progress(says_share_ ? share : 0);
    context.store({.index = {}});
  }

private:
  double seconds_;
  bool says_share_;
};

CaseFactory factory(std::shared_ptr<const Analysis> analysis) {
  return [analysis](const std::vector<parameters::Override> & /*overrides*/) {
    return Case{.analysis = analysis,
                .system =
                    testing::system_of(model::Model({testing::single_mass("block", 1, 1, 0)})),
                .source = {}};
  };
}

TEST(CostTest, PointsOfASweepCountByTheirTypicalTime) {
  const auto sweep = std::make_shared<Steps>(200, 0.01);
  const Cost cost = estimate_cost({}, factory(sweep), 0.6);
  EXPECT_EQ(cost.points, 200u);
  EXPECT_TRUE(cost.sentence().starts_with("200 points, ")) << cost.sentence();
  EXPECT_LT(cost.tried, 60u);
  EXPECT_NEAR(cost.seconds, 209 * 0.01, 0.3 * 209 * 0.01);
  EXPECT_EQ(cost.failed, 0u);
}

TEST(CostTest, PlacesLieAllOverTheSweep) {
  const auto sweep = std::make_shared<Steps>(1000, 1e-5);
  estimate_cost({}, factory(sweep), 0.5);
  for (std::size_t quarter = 0; quarter < 4; ++quarter)
    EXPECT_LT(*sweep->tried.lower_bound(250 * quarter), 250 * (quarter + 1)) << quarter;
}

TEST(CostTest, AShortRunIsTriedAsAWhole) {
  const auto sweep = std::make_shared<Steps>(20, 1e-5);
  const Cost cost = estimate_cost({}, factory(sweep), 0.5);
  EXPECT_EQ(sweep->tried.size(), 20u);
  EXPECT_EQ(cost.error, 0);
}

TEST(CostTest, EveryCaseOfAGridCounts) {
  const GridKey key{.path = "Variables/x", .values = std::vector<std::string>(50, "1")};
  const Cost cost = estimate_cost({key}, factory(std::make_shared<Motion>(0.05)), 0.6);
  EXPECT_EQ(cost.points, 50u);
  EXPECT_NEAR(cost.seconds, 2.5, 0.8);
}

TEST(CostTest, OfALongMotionAPartIsTried) {
  const double start = processor_seconds();
  const Cost cost = estimate_cost({}, factory(std::make_shared<Motion>(50)), 0.2);
  EXPECT_LT(processor_seconds() - start, 1);
  EXPECT_TRUE(cost.by_parts);
  EXPECT_EQ(cost.tried, 0u);
  EXPECT_NEAR(cost.seconds, 50, 10);
  EXPECT_TRUE(cost.sentence().starts_with("1 point, ")) << cost.sentence();
  EXPECT_NE(cost.sentence().find("settles early"), std::string::npos);
}

// Each case takes at least as long as it was tried.
TEST(CostTest, CasesOfUnknownLengthAllCount) {
  const GridKey key{.path = "Variables/x", .values = std::vector<std::string>(1000, "1")};
  const Cost cost = estimate_cost({key}, factory(std::make_shared<Motion>(50, false)), 0.4);
  EXPECT_TRUE(cost.at_least);
  EXPECT_GT(cost.seconds, 10);
  EXPECT_FALSE(cost.memory_known);
  EXPECT_TRUE(cost.sentence().starts_with("1000 points, more than ")) << cost.sentence();
}

TEST(CostTest, ResultsNeedTheMemoryOfAllPoints) {
  const Cost cost = estimate_cost({}, factory(std::make_shared<Steps>(2000, 1e-5)), 0.2);
  EXPECT_TRUE(cost.memory_known);
  EXPECT_GT(cost.memory, 2 * 2000 * 100 * 8); // in the journal and in the arrays
  EXPECT_LT(cost.memory, 2 * 2000 * 110 * 8);
}

TEST(CostTest, DurationsHaveTheirUnit) {
  EXPECT_EQ(duration_text(0.349), "0.35 s");
  EXPECT_EQ(duration_text(432), "432 s");
  EXPECT_EQ(duration_text(1800), "30 min");
  EXPECT_EQ(duration_text(9000), "2.5 h");
  EXPECT_EQ(duration_text(3608404), "42 days");
}

TEST(CostTest, FailedPointsAreTold) {
  const auto sweep = std::make_shared<Steps>(3, 1e-5, "too many steps");
  const Cost cost = estimate_cost({}, factory(sweep), 0.5);
  EXPECT_EQ(cost.failed, cost.tried);
  EXPECT_NE(cost.sentence().find("tried points failed: too many steps"), std::string::npos);
}

TEST(CostTest, CasesThatCannotBeBuiltAreTold) {
  const GridKey key{.path = "Variables/x", .values = {"1", "2", "3"}};
  const auto motion = factory(std::make_shared<Motion>(0.01));
  const Cost cost = estimate_cost(
      {key},
      [&](const std::vector<parameters::Override> &overrides) {
        if (overrides.front().value == "2")
          throw InputError("2 is impossible");
        return motion(overrides);
      },
      0.5);
  EXPECT_EQ(cost.failed, 1u);
  EXPECT_EQ(cost.reason, "2 is impossible");
}

} // namespace cost_tests
} // namespace vibroimpact::analyses
