#include "structure/sparse_rows.h"

namespace vibroimpact::structure {

using petsc::check;

petsc::Matrix sparse_matrix(const FreeDofs &free, const SparseRows &rows,
                            const std::vector<double> &values, MPI_Comm communicator) {
  const PetscInt own = free.own_end - free.own_begin;
  petsc::Matrix matrix;
  check(MatCreate(communicator, matrix.address()), "Making a matrix");
  check(MatSetSizes(matrix.get(), own, own, free.size, free.size), "Making a matrix");
  check(MatSetType(matrix.get(), MATAIJ), "Making a matrix");
  // Only the one that fits the number of ranks does anything.
  check(MatSeqAIJSetPreallocationCSR(matrix.get(), rows.begins.data(), rows.columns.data(),
                                     values.data()),
        "Assembling a matrix");
  check(MatMPIAIJSetPreallocationCSR(matrix.get(), rows.begins.data(), rows.columns.data(),
                                     values.data()),
        "Assembling a matrix");
  check(MatSetOption(matrix.get(), MAT_SYMMETRIC, PETSC_TRUE), "Marking a matrix symmetric");
  check(MatSetOption(matrix.get(), MAT_SYMMETRY_ETERNAL, PETSC_TRUE), "Marking a matrix symmetric");
  return matrix;
}

} // namespace vibroimpact::structure
