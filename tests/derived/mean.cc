#include "derived/small_analysis.h"

#include <cmath>
#include <limits>

namespace vibroimpact::derived {
namespace mean_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// gap + 10 frequency, backward one hundred more; missing at gap 1, frequency 2, forward, and at
/// gap 2 everywhere.
SmallAnalysis sums() {
  SmallAnalysis analysis({0, 1, 2}, {1, 2, 6});
  analysis.add("sum", "m", [](double gap, double frequency, bool forward) {
    const bool missing = gap == 2 || (gap == 1 && frequency == 2 && forward);
    return missing ? nan : gap + 10 * frequency + (forward ? 0 : 100);
  });
  return analysis;
}

TEST(Mean, AlongOneAxisPassesOverWhatIsMissing) {
  const DerivedArray result =
      sums().derive_one("set Operation = mean\nset Field = sum\nset Along = frequency");
  EXPECT_EQ(result.unit, "m");
  EXPECT_EQ(result.operation, "mean");
  EXPECT_EQ(result.dimensions, (std::vector<std::string>{"Variables.gap", "direction"}));
  expect_values(result.values, {30, 130, 36, 131, nan, nan});
}

// Each value counts once, however they are spread over the axes: no mean of means.
TEST(Mean, AlongSeveralAxesOrAll) {
  const std::string mean = "set Operation = mean\nset Field = sum\nset Along = ";
  expect_values(sums().derive_one(mean + "direction, frequency").values,
                {80, (2 * 36.0 + 3 * 131.0) / 5, nan});
  const DerivedArray all = sums().derive_one(mean + "gap, direction, frequency");
  EXPECT_TRUE(all.dimensions.empty());
  expect_values(all.values, {(6 * 80.0 + 2 * 36.0 + 3 * 131.0) / 11});
}

TEST(Mean, BadInput) {
  expect_parts(sums().problem("set Operation = mean\nset Field = sum"), {"Along"});
  expect_parts(sums().problem("set Operation = mean\nset Field = sum\nset Along = depth"),
               {"Along = depth", "gap"});
  expect_parts(
      sums().problem("set Operation = mean\nset Field = sum\nset Along = gap\nset Level = 2"),
      {"Level"});
}

} // namespace mean_tests
} // namespace vibroimpact::derived
