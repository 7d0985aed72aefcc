#include "modes/vector_block.h"

#include "modes/sparse_product.h"

#include <petscblaslapack.h>

#include <algorithm>
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

namespace {

bool is_sparse(Mat matrix) {
  PetscBool sparse = PETSC_FALSE;
  check(PetscObjectTypeCompareAny(reinterpret_cast<PetscObject>(matrix), &sparse, MATSEQAIJ,
                                  MATMPIAIJ, ""),
        "Reading a matrix");
  return sparse == PETSC_TRUE;
}

/// c <- factor op(a) b + keep c. The BLAS that MUMPS uses is several times as fast as loops that
/// must run on every processor of the architecture.
void dense_product(const char *transposed, double factor, const Eigen::Ref<const Matrix> &a,
                   const Eigen::Ref<const Matrix> &b, double keep, Eigen::Ref<Matrix> c) {
  const auto rows = static_cast<PetscBLASInt>(c.rows());
  const auto columns = static_cast<PetscBLASInt>(c.cols());
  const auto inner = static_cast<PetscBLASInt>(b.rows());
  const auto a_stride = static_cast<PetscBLASInt>(std::max<Index>(1, a.outerStride()));
  const auto b_stride = static_cast<PetscBLASInt>(std::max<Index>(1, b.outerStride()));
  const auto c_stride = static_cast<PetscBLASInt>(std::max<Index>(1, c.outerStride()));
  BLASgemm_(transposed, "N", &rows, &columns, &inner, &factor, a.data(), &a_stride, b.data(),
            &b_stride, &keep, c.data(), &c_stride);
}

} // namespace

Block multiply(Mat matrix, Block x) {
  const Layout layout(matrix);
  if (x.cols() == 0)
    return x;
  if (is_sparse(matrix))
    return SparseProduct(matrix)(x);
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

void add_product(double factor, const Eigen::Ref<const Matrix> &x, const Matrix &c,
                 Eigen::Ref<Matrix> y) {
  if (y.size() > 0 && x.cols() > 0)
    dense_product("N", factor, x, c, 1, y);
}

Matrix inner_products(const Layout &layout, const Eigen::Ref<const Matrix> &x, const Block &y) {
  Matrix products = Matrix::Zero(x.cols(), y.cols());
  if (products.size() > 0 && x.rows() > 0)
    dense_product("T", 1, x, y, 0, products);
  MPI_Allreduce(MPI_IN_PLACE, products.data(), static_cast<int>(products.size()), MPI_DOUBLE,
                MPI_SUM, layout.communicator);
  return products;
}

Vector column_products(const Layout &layout, const Block &x, const Block &y) {
  Vector products(x.cols());
  for (Index j = 0; j < x.cols(); ++j)
    products[j] = x.col(j).dot(y.col(j));
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
