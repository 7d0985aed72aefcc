// A million random phases of stick and slip that end, or nearly so, on all ranks together: which
// changes are missed or invented. VIBROIMPACT_FLIGHTS sets another number.
#include "support/friction_flights.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <mpi.h>
#include <string>

namespace vibroimpact {
namespace million_friction_flights_tests {

using testing::FrictionFlightCounts;

constexpr long flights_of_a_system = 600;

TEST(MillionFrictionFlightsTest, StickAndSlipOfChains) {
  const char *number = std::getenv("VIBROIMPACT_FLIGHTS");
  const long wanted = number ? std::stol(number) : 1000000;
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  FrictionFlightCounts counts;
  for (long i = rank; counts.flights < wanted / ranks; i += ranks)
    testing::count_friction(1, static_cast<std::uint64_t>(i), flights_of_a_system, counts);
  for (long *value : {&counts.flights, &counts.changes, &counts.touches, &counts.undecided,
                      &counts.missed, &counts.invented, &counts.wrong_mode, &counts.apart})
    MPI_Allreduce(MPI_IN_PLACE, value, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  if (rank == 0)
    std::cout << counts.flights << " flights, " << counts.changes << " with a change, "
              << counts.touches << " touches within rounding, " << counts.undecided
              << " reported as undecided; " << counts.missed << " missed, " << counts.invented
              << " invented, " << counts.wrong_mode << " followed by another mode, " << counts.apart
              << " that end elsewhere unobserved\n";
  EXPECT_EQ(counts.wrong(), 0);
}

} // namespace million_friction_flights_tests
} // namespace vibroimpact
