// Shells on any number of ranks: the distributed solution against the one of each rank alone.
#include "modes/solve_shell.h"
#include "structure/shell_benchmarks.h"

#include <gtest/gtest.h>

namespace shell_ranks_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

TEST(ShellRanks, FrequenciesAreTheSame) {
  for (const CellShape shape : {CellShape::quadrilateral, CellShape::triangle}) {
    const Vector together = frequencies(square_plate(8, shape), 12, MPI_COMM_WORLD);
    const Vector alone = frequencies(square_plate(8, shape), 12, MPI_COMM_SELF);
    EXPECT_EQ(together.head(6).norm(), 0);
    for (int j = 6; j < 12; ++j)
      EXPECT_NEAR(together[j] / alone[j], 1, 1e-10) << j;
  }
}

TEST(ShellRanks, StaticDisplacementsAreTheSame) {
  const Vector together = static_at_point(scordelis_lo_roof(8), MPI_COMM_WORLD);
  const Vector alone = static_at_point(scordelis_lo_roof(8), MPI_COMM_SELF);
  EXPECT_LT((together - alone).norm(), 1e-9 * alone.norm());
}

} // namespace shell_ranks_tests
