// Products of a distributed sparse matrix with several vectors at once. PETSc multiplies with one
// column after the other where the ranks are several; here the matrix is read once for eight
// columns, whose entries of a row lie side by side.
#pragma once

#include "modes/vector_block.h"

#include <vector>

namespace vibroimpact::modes {

/// Of an AIJ matrix, sequential or distributed, which outlives this object.
class SparseProduct {
public:
  /// Collective.
  explicit SparseProduct(Mat matrix);
  /// A x, this rank's rows. Collective.
  Block operator()(const Block &x) const;

private:
  /// Rows of `part` times the packed columns.
  struct Part {
    Mat matrix = nullptr;
    const PetscInt *row_begins = nullptr;
    const PetscInt *columns = nullptr;
  };

  static Part part(Mat matrix);
  void find_ghosts(Mat matrix, const PetscInt *columns);
  void fetch_ghosts(const Block &x, Index first, Index count, std::vector<double> &packed) const;

  Layout layout_;
  Part own_;
  Part outside_; ///< columns of other ranks; no matrix on a single rank
  structure::petsc::Vector distributed_, ghosts_;
  structure::petsc::Scatter scatter_;
  Index ghost_count_ = 0;
};

} // namespace vibroimpact::modes
