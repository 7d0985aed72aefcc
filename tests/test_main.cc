// Starts MPI, PETSc and SLEPc once for all tests of a program; under mpirun a failure on any rank
// fails the program.
#include "support/slepc_session.h"

#include <gtest/gtest.h>

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const vibroimpact::testing::SlepcSession session("test");
  int failed = RUN_ALL_TESTS();
  int failed_anywhere = 0;
  MPI_Allreduce(&failed, &failed_anywhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return failed_anywhere;
}
