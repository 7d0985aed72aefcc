#include "derived/small_analysis.h"

#include <cmath>
#include <limits>

namespace vibroimpact::derived {
namespace spread_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Squares of the frequencies 1, 2, 4, 8 times the gap; at gap 3 all but one are missing.
SmallAnalysis squares() {
  SmallAnalysis analysis({1, 2, 3}, {1, 2, 4, 8});
  analysis.add("square", "m", [](double gap, double frequency, bool) {
    return gap == 3 && frequency > 1 ? nan : gap * frequency * frequency;
  });
  return analysis;
}

DerivedArray derived_forward(const std::string &operation) {
  return squares().derive_one("set Operation = " + operation +
                              "\nset Field = square\nset Along = frequency");
}

// Of 1, 4, 16, 64: mean 21.25, squares of the deviations 2562.75 in all.
TEST(Spread, DeviationAndErrorOfTheMean) {
  const double deviation = std::sqrt(2562.75 / 3);
  expect_values(derived_forward("standard deviation").values,
                {deviation, deviation, 2 * deviation, 2 * deviation, nan, nan});
  expect_values(derived_forward("standard error").values,
                {deviation / 2, deviation / 2, deviation, deviation, nan, nan});
  EXPECT_EQ(derived_forward("standard error").unit, "m");
}

TEST(Spread, QuantilesAreLinearBetweenTheValues) {
  const auto quantile = [](const std::string &probability) {
    return derived_forward("quantile\nset Probability = " + probability).values;
  };
  expect_values(quantile("0"), {1, 1, 2, 2, 3, 3});
  expect_values(quantile("1"), {64, 64, 128, 128, 3, 3});
  expect_values(quantile("0.5"), {10, 10, 20, 20, 3, 3});
  expect_values(quantile("0.9"), {49.6, 49.6, 99.2, 99.2, 3, 3});
}

TEST(Spread, BadInput) {
  expect_parts(
      squares().problem("set Operation = quantile\nset Field = square\nset Along = frequency"),
      {"Probability"});
  expect_parts(
      squares().problem("set Operation = quantile\nset Probability = 1.5\nset Field = square\n"
                        "set Along = frequency"),
      {"Probability", "1"});
  expect_parts(
      squares().problem("set Operation = standard error\nset Field = square\nset Along = depth"),
      {"Along = depth", "gap"});
}

} // namespace spread_tests
} // namespace vibroimpact::derived
