// Products with several vectors at once against those of PETSc with one.
#include "modes/sparse_product.h"

#include "modes/small_problem.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sparse_product_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

TEST(SparseProduct, IsThatOfPetsc) {
  const structure::petsc::Matrix matrix =
      band_matrix(37, 5, [](int i, int j) { return 1.0 / (1 + i + j); });
  const modes::Layout layout(matrix.get());
  const modes::SparseProduct product(matrix.get());
  for (const Index columns : {1, 5, 6, 8, 9, 19}) {
    modes::Block x(layout.own, columns);
    for (Index i = 0; i < layout.own; ++i)
      for (Index j = 0; j < columns; ++j)
        x(i, j) = std::cos(1.0 + static_cast<double>((layout.own_begin + i) * (j + 2)));
    const modes::Block y = product(x);
    structure::petsc::Vector in;
    structure::petsc::Vector out;
    MatCreateVecs(matrix.get(), in.address(), out.address());
    for (Index j = 0; j < columns; ++j) {
      double *values = nullptr;
      VecGetArray(in.get(), &values);
      std::copy_n(x.col(j).data(), layout.own, values);
      VecRestoreArray(in.get(), &values);
      MatMult(matrix.get(), in.get(), out.get());
      const double *expected = nullptr;
      VecGetArrayRead(out.get(), &expected);
      for (Index i = 0; i < layout.own; ++i)
        EXPECT_NEAR(y(i, j), expected[i], 1e-14);
      VecRestoreArrayRead(out.get(), &expected);
    }
  }
}

} // namespace sparse_product_tests
