#include "continuation/harmonic_series.h"

#include "algebraic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace vibroimpact::continuation {
namespace harmonic_series_tests {

TEST(HarmonicSeriesTest, RangeIsThatOfTheFunction) {
  RowVector series(5);
  series << 0.5, 0, 1, 0.25, 0; // 0.5 + sin phi + cos(2 phi) / 4: stationary at cos = 0, sin = 1
  const SeriesRange range = range_of(series);
  EXPECT_NEAR(range.maximum, 0.5 + 1 - 0.25, 1e-14);
  EXPECT_NEAR(range.minimum, 0.5 - 1 - 0.25, 1e-14);
  series << 0, 0, 1, 0, 0.5; // sin phi + sin(2 phi) / 2 = 3 sqrt(3) / 4 at 60 degrees
  EXPECT_NEAR(range_of(series).maximum, 0.75 * std::sqrt(3.0), 1e-14);
  EXPECT_EQ(range_of(vector({-2}).transpose()).maximum, -2);
}

TEST(HarmonicSeriesTest, RateIsTheDerivative) {
  const RowVector series = RowVector::LinSpaced(7, -1, 2);
  const RowVector rate = series * harmonic_rate(3);
  for (const double phase : {0.3, 2.0, 5.5}) {
    const double ahead = series.dot(harmonic_basis(phase + 1e-6, 3));
    const double behind = series.dot(harmonic_basis(phase - 1e-6, 3));
    EXPECT_NEAR(rate.dot(harmonic_basis(phase, 3)), (ahead - behind) / 2e-6, 1e-8);
  }
  EXPECT_THROW(harmonics_of(4), std::logic_error);
}

} // namespace harmonic_series_tests
} // namespace vibroimpact::continuation
