// Blocks of distributed vectors: each rank holds its rows of all of them as one dense matrix.
#pragma once

#include "common/linear_algebra.h"
#include "structure/petsc_object.h"

namespace vibroimpact::modes {

/// The rows this rank owns (as PETSc shares out the rows of the matrices) x vectors.
using Block = Matrix;

/// Row-wise layout of the blocks, taken from a matrix.
struct Layout {
  explicit Layout(Mat matrix);
  MPI_Comm communicator;
  int size;      ///< rows of all ranks
  int own_begin; ///< first row of this rank
  int own;       ///< rows of this rank
};

/// The columns of a block as a PETSc matrix, which works on its memory. Collective.
structure::petsc::Matrix wrap(const Layout &layout, Block &x);
/// A x. Collective.
Block multiply(Mat matrix, Block x);
/// y += factor x c, for the rows of this rank.
void add_product(double factor, const Eigen::Ref<const Matrix> &x, const Matrix &c,
                 Eigen::Ref<Matrix> y);
/// x^T y over all ranks, the same on every rank. Collective.
Matrix inner_products(const Layout &layout, const Eigen::Ref<const Matrix> &x, const Block &y);
/// Of each column of x with the same one of y alone. Collective.
Vector column_products(const Layout &layout, const Block &x, const Block &y);
/// All rows on every rank. Collective.
Matrix gather(const Layout &layout, const Block &x);
/// This rank's rows of a matrix that all ranks hold.
Block own_rows(const Layout &layout, const Matrix &x);

/// Phi^T A Phi for shapes that all ranks hold: rows are those of `matrix`. Collective.
Matrix project(Mat matrix, const Matrix &shapes);

} // namespace vibroimpact::modes
