// Random flights that graze a stop or nearly so: no contact is missed and none invented, but where
// rounding decides. The verification program flies a million of them.
#include "support/flight_counts.h"

#include <gtest/gtest.h>

namespace vibroimpact::motion {
namespace {

using testing::count_system;
using testing::FlightCounts;

FlightCounts count(int systems, int flights, bool safe_path) {
  FlightCounts counts;
  for (int i = 0; i < systems; ++i)
    count_system(20, static_cast<std::uint64_t>(i), flights, safe_path, counts);
  return counts;
}

void expect_sound(const FlightCounts &counts) {
  for (const FlightCounts::Path &path : counts.path) {
    EXPECT_EQ(path.missed, 0);
    EXPECT_EQ(path.invented, 0);
    EXPECT_EQ(path.reported_outside, 0);
  }
  // What they were made for.
  EXPECT_GT(counts.contacts, counts.flights / 5);
  EXPECT_GT(counts.near, counts.flights / 10);
  EXPECT_GT(counts.in_band, 0);
}

TEST(GrazingFlightsTest, ByEigenvectors) { expect_sound(count(60, 60, false)); }

TEST(GrazingFlightsTest, BySeries) { expect_sound(count(40, 30, true)); }

} // namespace
} // namespace vibroimpact::motion
