// Compressed rows of this rank, and PETSc's matrix of them.
#pragma once

#include "structure/stiffness_operator.h"

namespace vibroimpact::structure {

/// Several arrays of values may share them.
struct SparseRows {
  std::vector<int> begins{0};
  std::vector<int> columns;
};

/// Symmetric; the rows are the free degrees of freedom of this rank. Collective.
petsc::Matrix sparse_matrix(const FreeDofs &free, const SparseRows &rows,
                            const std::vector<double> &values, MPI_Comm communicator);

} // namespace vibroimpact::structure
