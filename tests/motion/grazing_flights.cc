// Random flights that graze a stop or nearly so: no contact is missed and none invented, but where
// rounding decides. The verification program flies a million of them.
#include "support/flight_counts.h"

#include <gtest/gtest.h>

namespace vibroimpact::motion {
namespace grazing_flights_tests {

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

// The left stop is reached with a slope of 1e-12 m/s and no curvature to speak of: Halley's method
// goes far away from such a zero, which was then taken for one beyond the end of the flight.
TEST(GrazingFlightsTest, AFlatInflectionAtAStop) {
  const testing::RandomSystem system{
      .modes = {{436.36056223882304L, 0, 0.35172311666306538L, -0.067004596204436079L},
                {13616.85731986998L, 0, -0.4227822752871398L, 1.5080217822357442L},
                {437.03532794544111L, 0, 0.32700282253916269L, -0.63786762061119329L},
                {653.87612357154501L, 0, 1.035709918373638L, -1.0050507114327702L}},
      .force = {4.4518597727854106L, 126.52203422986099L, -0.65844778452066599L},
      .right = 0.0033725027678997948,
      .left = 0.0042207396274606263,
      .period = 0.3};
  const testing::RandomFlight flight{
      .displacement = {0.0013814332638681041, -0.00012242924811535811, -0.0014276412019825269,
                       0.0021641958955289061},
      .velocity = {-0.057467717797876995, -0.10046995484641476, 0.1078017964708001,
                   0.035565038373454275},
      .end = 0.09773355098226541};
  FlightCounts counts;
  testing::FlightCounter(system).count(flight, counts);
  EXPECT_EQ(counts.contacts, 1);
  EXPECT_EQ(counts.wrong(), 0);
}

TEST(GrazingFlightsTest, BySeries) { expect_sound(count(40, 30, true)); }

} // namespace grazing_flights_tests
} // namespace vibroimpact::motion
