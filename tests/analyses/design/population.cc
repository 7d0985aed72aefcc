// What a population does with trials.
#include "analyses/design/population.h"

#include <gtest/gtest.h>

#include <set>

namespace vibroimpact::analyses {
namespace population_tests {

Population population(std::size_t size, std::uint64_t seed = 1) {
  return Population({.size = size, .start = Vector::Constant(2, 0.5), .seed = seed});
}

TEST(PopulationTest, TheOrderOfTrials) {
  const TrialValue good{.goals = {1, 2}}, worse{.goals = {1, 3}}, other{.goals = {2, 1}};
  const TrialValue missing{.excess = 0.1, .goals = {0, 0}}, more{.excess = 0.2, .goals = {0, 0}};
  const TrialValue failed{.failed = true, .goals = {0, 0}};
  EXPECT_TRUE(dominates(good, worse));
  EXPECT_FALSE(dominates(worse, good));
  EXPECT_FALSE(dominates(good, other));
  EXPECT_FALSE(dominates(other, good));
  EXPECT_FALSE(dominates(good, good));
  EXPECT_TRUE(dominates(worse, missing));
  EXPECT_TRUE(dominates(missing, more));
  EXPECT_TRUE(dominates(more, failed));
  EXPECT_FALSE(dominates(failed, more));
  EXPECT_EQ(not_dominated({good, worse, other, failed, missing}), (std::vector<std::size_t>{0, 2}));
}

// Of a Latin hypercube of N points, each of N equal parts of each coordinate has one.
TEST(PopulationTest, TheFirstTrialsAreSpreadOverTheBox) {
  const Population some = population(20);
  EXPECT_EQ(some.propose(0), Vector::Constant(2, 0.5));
  for (Index j = 0; j < 2; ++j) {
    std::set<int> parts;
    for (std::size_t trial = 1; trial < 20; ++trial)
      parts.insert(static_cast<int>(20 * some.propose(trial)[j]));
    EXPECT_EQ(parts.size(), 19U);
  }
}

TEST(PopulationTest, EqualSeedsGiveEqualTrials) {
  EXPECT_EQ(population(20).propose(3), population(20).propose(3));
  EXPECT_NE(population(20).propose(3), population(20, 2).propose(3));
}

TEST(PopulationTest, TrialsStayInTheBox) {
  Population some = population(8);
  for (std::size_t trial = 0; trial < 400; ++trial) {
    const Vector x = some.propose(trial);
    ASSERT_GE(x.minCoeff(), 0);
    ASSERT_LE(x.maxCoeff(), 1);
    some.take_in(trial, x, {.goals = {x.sum()}}); // least in a corner
  }
  EXPECT_LT(some.propose(400).maxCoeff(), 1e-3);
}

// With two objectives the members are what the crowding distance leaves of the front x + y = 1:
// both ends, and between them distances that differ little from 1/(N - 1).
TEST(PopulationTest, AFrontIsKeptWide) {
  const std::size_t size = 10;
  Population some = population(size);
  for (std::size_t trial = 0; trial < 200; ++trial) {
    const double x = static_cast<double>((trial * 83) % 200) / 199;
    some.take_in(trial, Vector::Constant(2, x), {.goals = {x, 1 - x}});
  }
  std::set<double> kept;
  for (const Vector &member : some.coordinates())
    kept.insert(member[0]);
  ASSERT_EQ(kept.size(), size);
  EXPECT_EQ(*kept.begin(), 0);
  EXPECT_EQ(*kept.rbegin(), 1);
  double widest = 0;
  for (auto next = std::next(kept.begin()); next != kept.end(); ++next)
    widest = std::max(widest, *next - *std::prev(next));
  EXPECT_LT(widest, 2.0 / (size - 1));
}

TEST(PopulationTest, ADominatedMemberLeavesFirst) {
  Population some = population(4);
  const std::vector<TrialValue> values{{.goals = {0, 4}},
                                       {.goals = {3, 3}},
                                       {.goals = {4, 0}},
                                       {.goals = {2, 2}},
                                       {.goals = {1, 2.5}}};
  for (std::size_t trial = 0; trial < values.size(); ++trial)
    some.take_in(trial, Vector::Constant(2, static_cast<double>(trial)), values[trial]);
  for (const Vector &member : some.coordinates())
    EXPECT_NE(member[0], 1); // (3, 3)
}

TEST(PopulationTest, WithoutMembersTrialsAreRandom) {
  EXPECT_NE(population(8).propose(20), population(8).propose(21));
}

} // namespace population_tests
} // namespace vibroimpact::analyses
