// Random phases of stick and slip that end, or nearly so: no change is missed and none invented,
// but where rounding decides. The verification program goes through a million of them.
#include "support/friction_flights.h"

#include <gtest/gtest.h>

namespace vibroimpact::motion {
namespace friction_flights_tests {

TEST(FrictionFlightsTest, StickAndSlipOfChains) {
  testing::FrictionFlightCounts counts;
  for (std::uint64_t i = 0; i < 200; ++i)
    testing::count_friction(5, i, 60, counts);
  EXPECT_EQ(counts.missed, 0);
  EXPECT_EQ(counts.invented, 0);
  EXPECT_EQ(counts.wrong_mode, 0);
  EXPECT_EQ(counts.apart, 0);
  // What they were made for.
  EXPECT_GT(counts.flights, 3000);
  EXPECT_GT(counts.changes, counts.flights / 5);
  EXPECT_GT(counts.touches, 10);
  EXPECT_LT(counts.undecided, counts.flights / 20);
}

} // namespace friction_flights_tests
} // namespace vibroimpact::motion
