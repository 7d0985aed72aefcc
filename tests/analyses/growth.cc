// Mean growth of a deviation and its error, for logarithms whose means are plain.
#include "analyses/signals/growth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::analyses {
namespace growth_tests {

Growth growth_of(const std::vector<double> &logarithms, double discarded = 0) {
  Growth growth(discarded);
  for (const double logarithm : logarithms)
    growth.add(0.5, logarithm);
  return growth;
}

TEST(GrowthTest, MeanOfWhatIsNotDiscarded) {
  EXPECT_DOUBLE_EQ(growth_of({1, 2, 3, 4}).exponent(), 5);
  const Growth late = growth_of({100, 2, 3, 4}, 0.25);
  EXPECT_DOUBLE_EQ(late.exponent(), 6);
  EXPECT_EQ(late.running_exponent(), (std::vector<double>{4, 5, 6}));
  EXPECT_EQ(late.elapsed(), (std::vector<double>{1, 1.5, 2}));
  EXPECT_TRUE(std::isnan(growth_of({}).exponent()));
}

// Rates 2, 4, 6, 8 in blocks of two: means 3 and 7, standard deviation sqrt(8), error of the mean
// of two sqrt(8 / 2) = 2. In blocks 1, 5, 6 of three times two: squares 9 + 1 + 4 = 14 about 4,
// error sqrt(14 / 2 / 3). What fills no block is left out at the start.
TEST(GrowthTest, StandardErrorOfTheMeanOfBlocks) {
  EXPECT_DOUBLE_EQ(growth_of({1, 2, 3, 4}).standard_error(2), 2);
  EXPECT_DOUBLE_EQ(growth_of({50, 0.5, 0.5, 2, 3, 3, 3}).standard_error(3), std::sqrt(14.0 / 6));
  EXPECT_DOUBLE_EQ(growth_of({7, 7, 1, 2, 3, 4}, 0.4).standard_error(2), 2);
  EXPECT_TRUE(std::isnan(growth_of({1, 2, 3}).standard_error(2)));
}

} // namespace growth_tests
} // namespace vibroimpact::analyses
