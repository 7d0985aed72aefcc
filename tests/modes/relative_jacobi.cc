#include "modes/relative_jacobi.h"

#include <gtest/gtest.h>

namespace relative_jacobi_tests {

using namespace vibroimpact;

// D [[1, 1/2], [1/2, 1]] D with D = diag(1e-12, 1): determinant 3/4 1e-24, so the small eigenvalue
// is 0.75e-24 to 24 digits although the matrix has entries of size 1.
TEST(RelativeJacobi, SmallEigenvaluesOfGradedMatricesKeepTheirDigits) {
  Matrix a(2, 2);
  a << 1e-24, 0.5e-12, 0.5e-12, 1;
  const modes::DenseEigenpairs pairs = modes::relative_jacobi(a, 0);
  EXPECT_NEAR(pairs.values[0] / 0.75e-24, 1, 1e-14);
  EXPECT_NEAR(pairs.values[1], 1, 1e-14);
}

// The second-difference matrix of size n has the eigenvalues 4 sin^2(k pi / (2 n + 2)).
TEST(RelativeJacobi, SecondDifferenceMatrix) {
  const Index n = 30;
  Matrix a = Matrix::Zero(n, n);
  a.diagonal().setConstant(2);
  a.diagonal(1).setConstant(-1);
  a.diagonal(-1).setConstant(-1);
  const modes::DenseEigenpairs pairs = modes::relative_jacobi(a, 0);
  const double round_off = n * std::numeric_limits<double>::epsilon() * 4;
  for (Index k = 1; k <= n; ++k)
    EXPECT_NEAR(pairs.values[k - 1], 4 * std::pow(std::sin(k * M_PI / (2 * n + 2)), 2), round_off);
  EXPECT_LT((a * pairs.vectors - pairs.vectors * pairs.values.asDiagonal()).norm(), 1e-13);
  EXPECT_LT((pairs.vectors.transpose() * pairs.vectors - Matrix::Identity(n, n)).norm(), 1e-13);
}

TEST(RelativeJacobi, ZeroBlocksStayZero) {
  Matrix a = Matrix::Zero(3, 3);
  a(1, 1) = 5;
  a(0, 2) = a(2, 0) = 1e-30;
  const modes::DenseEigenpairs pairs = modes::relative_jacobi(a, 1e-10);
  EXPECT_EQ(pairs.values[0], 0);
  EXPECT_EQ(pairs.values[2], 5);
}

} // namespace relative_jacobi_tests
