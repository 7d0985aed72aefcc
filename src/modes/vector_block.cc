#include "modes/vector_block.h"

#include <vector>

namespace vibroimpact::modes {

using petsc::check;

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

Block map_columns(const Layout &layout, const Block &x, const std::function<void(Vec, Vec)> &map) {
  Block y = Block::Zero(x.rows(), x.cols());
  for (Index j = 0; j < x.cols(); ++j) {
    petsc::Vector in;
    petsc::Vector out;
    check(VecCreateMPIWithArray(layout.communicator, 1, layout.own, layout.size, x.col(j).data(),
                                in.address()),
          "Wrapping a vector");
    check(VecCreateMPIWithArray(layout.communicator, 1, layout.own, layout.size, y.col(j).data(),
                                out.address()),
          "Wrapping a vector");
    map(in.get(), out.get());
  }
  return y;
}

Block multiply(Mat matrix, const Block &x) {
  return map_columns(Layout(matrix), x, [matrix](Vec in, Vec out) {
    check(MatMult(matrix, in, out), "Multiplying with a matrix");
  });
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
