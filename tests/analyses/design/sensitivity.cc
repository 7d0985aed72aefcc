// Sensitivities on outcomes that are known functions of the keys.
#include "analyses/design/sensitivity.h"
#include "analyses/design/known_outcomes.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace sensitivity_tests {

std::shared_ptr<const Analysis> sensitivity(const std::string &lines) {
  return search_analysis(R"(set Type = sensitivity
subsection Sensitivity
set Repeat = other
set Samples = 1000
subsection Key x
  set Path = Variables/x
  set Lower = 0
  set Upper = 3
end
subsection Key y
  set Path = Variables/y
  set Lower = 1
  set Upper = 100
  set Scale = logarithmic
end
subsection Quantity sum
  set Quantity = f
end
)" + lines + "end\n");
}

// x + ln y: variances 9/12 and (ln 100)^2 / 12.
std::vector<double> sum(const Arguments &at) {
  return {at.at("x") + std::log(at.at("y")), at.at("x")};
}

TEST(SensitivityTest, KeysAreDrawnBetweenTheirBounds) {
  const KnownOutcomes outcomes(sum);
  SearchPoints points(outcomes);
  run_all(*sensitivity("subsection Quantity alone\nset Quantity = g\nend\n"), points);
  EXPECT_EQ(outcomes.calls, 4000);
  const double of_x = 9, of_y = std::pow(std::log(100.0), 2);
  const auto near = [&](const std::string &path, double expected) {
    EXPECT_NEAR(points.value({0}, path), expected,
                4 * points.value({0}, path.substr(0, path.find('/')) + "_error" +
                                          path.substr(path.find('/'))))
        << path;
  };
  near("first_order/sum/x", of_x / (of_x + of_y));
  near("total/sum/x", of_x / (of_x + of_y));
  near("first_order/sum/y", of_y / (of_x + of_y));
  near("total/sum/y", of_y / (of_x + of_y));
  near("total/alone/x", 1);
  EXPECT_EQ(points.value({0}, "total/alone/y"), 0);
  EXPECT_NEAR(points.value({0}, "deviation/sum"), std::sqrt((of_x + of_y) / 12), 0.1);
  EXPECT_NEAR(points.value({0}, "mean/sum"), 1.5 + std::log(10.0), 0.2);
  EXPECT_EQ(points.value({7}, "quantity/alone"), points.value({7}, "key/x"));
}

TEST(SensitivityTest, SamplesWithAFailureAreLeftOut) {
  const KnownOutcomes outcomes([](const Arguments &at) {
    if (at.at("x") < 0.3)
      throw NumericalError("too small an x");
    return sum(at);
  });
  SearchPoints points(outcomes);
  run_all(*sensitivity(""), points);
  std::size_t failed = 0;
  for (const auto &[index, point] : points.all())
    if (index[0] > 0 && point.status == Status::failed) {
      ++failed;
      EXPECT_EQ(point.reason, "too small an x");
    }
  EXPECT_GT(failed, 300U);
  // of A, of B and of A with the x of B: 0.9^2 of all rows
  EXPECT_NEAR(points.value({0}, "samples/sum"), 810, 60);
}

TEST(SensitivityTest, WithoutAnySampleItSaysWhy) {
  const KnownOutcomes outcomes(
      [](const Arguments &) -> std::vector<double> { throw NumericalError("no motion"); });
  SearchPoints points(outcomes);
  run_all(*sensitivity(""), points);
  EXPECT_NE(points.all().at({0}).reason.find("the first that failed: no motion"),
            std::string::npos);
}

TEST(SensitivityTest, WhatIsStoredIsNotComputedAgain) {
  const KnownOutcomes outcomes(sum);
  const auto analysis = sensitivity("");
  SearchPoints whole(outcomes);
  run_all(*analysis, whole);
  SearchPoints resumed(outcomes);
  for (const auto &[index, point] : whole.all())
    if (index[0] > 0 && index[0] % 2 == 0)
      resumed.know(point);
  outcomes.calls = 0;
  run_all(*analysis, resumed);
  EXPECT_EQ(outcomes.calls, 2000);
  EXPECT_EQ(resumed.value({0}, "total/sum/x"), whole.value({0}, "total/sum/x"));
}

} // namespace sensitivity_tests
} // namespace vibroimpact::analyses
