#include "output/yield_excess.h"

#include <gtest/gtest.h>
#include <limits>

namespace vibroimpact::output {
namespace yield_excess_tests {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

PointResult point_with(const std::string &field, const std::vector<double> &values) {
  PointResult point;
  point.fields.push_back({.label = Label(field, "Pa", ""), .values = values});
  return point;
}

std::string lines_of(const YieldExcess &excess) {
  SummaryList list;
  excess.add_to(list, "analysis.a");
  return list.text();
}

TEST(YieldExcess, TheLargestStressOfABodyCounts) {
  YieldExcess excess({{"beam", 200e6}, {"plate", 100e6}, {"frame", 1e6}});
  excess.add(point_with("point/beam.root/von_mises_stress/maximum", {100e6}));
  excess.add(point_with("point/beam.tip/von_mises_stress/maximum", {30e6, 250e6, nan, 20e6}));
  excess.add(point_with("body/plate/von_mises_stress/maximum", {100e6}));
  EXPECT_EQ(lines_of(excess), "analysis.a.body.beam.yield_ratio = 1.25 [1]\n"
                              "analysis.a.body.plate.yield_ratio = 1 [1]\n");
  ASSERT_EQ(excess.warnings().size(), 1U);
  EXPECT_NE(excess.warnings()[0].find("body beam: the von Mises stress at beam.tip reaches 1.25 "
                                      "times the Yield stress"),
            std::string::npos)
      << excess.warnings()[0];
}

TEST(YieldExcess, OtherFieldsAndBodiesDoNotCount) {
  YieldExcess excess({{"beam", 1.0}});
  excess.add(point_with("point/beam.tip/displacement_x/maximum", {2}));
  excess.add(point_with("derivative/k/point/beam.tip/von_mises_stress/maximum", {2}));
  excess.add(point_with("point/other.tip/von_mises_stress/maximum", {2}));
  excess.add(point_with("body/beam/von_mises_stress/time", {2}));
  EXPECT_EQ(lines_of(excess), "");
  EXPECT_TRUE(excess.warnings().empty());
}

TEST(YieldExcess, WithoutAYieldStressThereIsNothing) {
  YieldExcess excess;
  excess.add(point_with("point/beam.tip/von_mises_stress/maximum", {1e9}));
  EXPECT_EQ(lines_of(excess), "");
}

TEST(YieldExcess, WhatATransientRecordsCounts) {
  YieldExcess excess({{"beam", 200e6}});
  excess.add(point_with("recorded/point/beam.root/von_mises_stress/maximum", {300e6}));
  EXPECT_EQ(lines_of(excess), "analysis.a.body.beam.yield_ratio = 1.5 [1]\n");
}

} // namespace yield_excess_tests
} // namespace vibroimpact::output
