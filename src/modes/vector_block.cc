#include "modes/vector_block.h"

#include <vector>

namespace vibroimpact::modes {

using structure::petsc::check;

Layout::Layout(Mat matrix)
    : communicator(PetscObjectComm(reinterpret_cast<PetscObject>(matrix))), size(0), own_begin(0),
      own(0) {
  PetscInt begin = 0;
  PetscInt end = 0;
  PetscInt rows = 0;
  check(MatGetOwnershipRange(matrix, &begin, &end), "Reading a matrix");
  check(MatGetSize(matrix, &rows, nullptr), "Reading a matrix");
  size = static_cast<int>(rows);
  own_begin = static_cast<int>(begin);
  own = static_cast<int>(end - begin);
}

structure::petsc::Matrix wrap(const Layout &layout, Block &x) {
  structure::petsc::Matrix dense;
  check(MatCreateDense(layout.communicator, layout.own, PETSC_DECIDE, layout.size,
                       static_cast<PetscInt>(x.cols()), x.data(), dense.address()),
        "Wrapping vectors");
  return dense;
}

// The matrix is read once for several columns.
Block multiply(Mat matrix, Block x) {
  const Layout layout(matrix);
  if (x.cols() == 0)
    return x;
  const structure::petsc::Matrix in = wrap(layout, x);
  structure::petsc::Matrix out;
  check(MatMatMult(matrix, in.get(), MAT_INITIAL_MATRIX, PETSC_DEFAULT, out.address()),
        "Multiplying with a matrix");
  const double *products = nullptr;
  check(MatDenseGetArrayRead(out.get(), &products), "Multiplying with a matrix");
  Block y = Eigen::Map<const Block>(products, x.rows(), x.cols());
  check(MatDenseRestoreArrayRead(out.get(), &products), "Multiplying with a matrix");
  return y;
}

Matrix inner_products(const Layout &layout, const Block &x, const Block &y) {
  Matrix products = x.transpose() * y;
  MPI_Allreduce(MPI_IN_PLACE, products.data(), static_cast<int>(products.size()), MPI_DOUBLE,
                MPI_SUM, layout.communicator);
  return products;
}

Matrix gather(const Layout &layout, const Block &x) {
  int ranks = 1;
  MPI_Comm_size(layout.communicator, &ranks);
  std::vector<int> counts(ranks);
  std::vector<int> begins(ranks);
  MPI_Allgather(&layout.own, 1, MPI_INT, counts.data(), 1, MPI_INT, layout.communicator);
  MPI_Allgather(&layout.own_begin, 1, MPI_INT, begins.data(), 1, MPI_INT, layout.communicator);
  Matrix all(layout.size, x.cols());
  for (Index j = 0; j < x.cols(); ++j)
    MPI_Allgatherv(x.col(j).data(), layout.own, MPI_DOUBLE, all.col(j).data(), counts.data(),
                   begins.data(), MPI_DOUBLE, layout.communicator);
  return all;
}

Block own_rows(const Layout &layout, const Matrix &x) {
  return x.middleRows(layout.own_begin, layout.own);
}

Matrix project(Mat matrix, const Matrix &shapes) {
  const Layout layout(matrix);
  const Block own = own_rows(layout, shapes);
  return inner_products(layout, own, multiply(matrix, own));
}

} // namespace vibroimpact::modes
