// A million random flights that graze a stop or nearly so, on all ranks together: which contacts
// are missed, invented, or undecided within the round-off of their evaluation. VIBROIMPACT_FLIGHTS
// sets another number.
#include "support/flight_counts.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <mpi.h>
#include <string>

namespace vibroimpact {
namespace million_flights_tests {

using testing::FlightCounts;

constexpr int flights_of_a_system = 600;

long wanted_flights() {
  const char *number = std::getenv("VIBROIMPACT_FLIGHTS");
  return number ? std::stol(number) : 1000000;
}

void add_over_ranks(FlightCounts &counts) {
  const auto sum = [](long &value) {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  };
  for (long *value : {&counts.flights, &counts.contacts, &counts.near, &counts.in_band})
    sum(*value);
  for (FlightCounts::Path &path : counts.path) {
    for (long *value : {&path.missed, &path.invented, &path.decided_in_band, &path.reported,
                        &path.reported_outside})
      sum(*value);
    MPI_Allreduce(MPI_IN_PLACE, &path.worst_instant, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  }
}

FlightCounts count_flights(long flights, bool safe_path) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  FlightCounts counts;
  const long systems = (flights + flights_of_a_system - 1) / flights_of_a_system;
  for (long i = rank; i < systems; i += ranks)
    count_system(1, static_cast<std::uint64_t>(i), flights_of_a_system, safe_path, counts);
  add_over_ranks(counts);
  return counts;
}

void print(const char *name, const FlightCounts &counts) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank > 0)
    return;
  std::cout << name << ": " << counts.flights << " flights, " << counts.contacts
            << " with a contact, " << counts.near << " within 1e-9 of touching, " << counts.in_band
            << " with a touch within rounding\n";
  for (std::size_t p = 0; p < counts.path.size(); ++p) {
    const FlightCounts::Path &path = counts.path[p];
    std::cout << (p == 0 ? "  observed:   " : "  unobserved: ") << path.missed << " missed, "
              << path.invented << " invented; within rounding: " << path.decided_in_band
              << " taken for contacts, " << path.reported << " reported as undecided, "
              << path.reported_outside << " reported outside it; largest error of an instant "
              << path.worst_instant << " s\n";
  }
}

void expect_sound(const FlightCounts &counts) {
  for (const FlightCounts::Path &path : counts.path) {
    EXPECT_EQ(path.missed, 0);
    EXPECT_EQ(path.invented, 0);
    EXPECT_EQ(path.reported_outside, 0);
  }
}

TEST(MillionFlightsTest, ByEigenvectors) {
  const FlightCounts counts = count_flights(wanted_flights() * 19 / 20, false);
  print("eigenvectors", counts);
  expect_sound(counts);
}

TEST(MillionFlightsTest, BySeries) {
  const FlightCounts counts = count_flights(wanted_flights() / 20, true);
  print("series", counts);
  expect_sound(counts);
}

} // namespace million_flights_tests
} // namespace vibroimpact
