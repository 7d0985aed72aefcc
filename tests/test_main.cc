// Starts MPI, PETSc and SLEPc once for all tests of a program; under mpirun a failure on any rank
// fails the program.
#include <gtest/gtest.h>
#include <slepcsys.h>

int main(int argc, char **argv) {
  testing::InitGoogleTest(&argc, argv);
  char program[] = "test";
  char skip[] = "-skip_petscrc";
  char *arguments[] = {program, skip, nullptr};
  int count = 2;
  char **private_arguments = arguments;
  if (SlepcInitialize(&count, &private_arguments, nullptr, nullptr) != 0)
    return 1;
  int failed = RUN_ALL_TESTS();
  int failed_anywhere = 0;
  MPI_Allreduce(&failed, &failed_anywhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  SlepcFinalize();
  return failed_anywhere;
}
