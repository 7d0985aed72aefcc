// Exponentials of matrices: of polynomials, whose series ends, and of others.
#include "common/decompositions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact {
namespace decompositions_tests {

// Over a long time too: t^k / k!, to rounding of each entry.
TEST(DecompositionsTest, OfShiftIsTaylorsPolynomial) {
  for (const double t : {1e-3, 0.7, 2000.0}) {
    Matrix shift = Matrix::Zero(6, 6);
    shift.diagonal(1).setConstant(t);
    const Matrix e = exponential(shift);
    double term = 1;
    for (Index k = 0; k < 6; term *= t / static_cast<double>(++k)) {
      EXPECT_NEAR(e(0, k), term, 1e-15 * term);
      EXPECT_NEAR(e(5 - k, 5), term, 1e-15 * term);
      EXPECT_EQ(e(5, k), k == 5 ? 1 : 0);
    }
  }
}

// exp(A + c 1) = exp(c) exp(A), which takes the other way.
TEST(DecompositionsTest, OfStrictlyUpperMatrixIsThatOfOthers) {
  Matrix a(4, 4);
  a << 0, 1.5, -2, 0.3, 0, 0, 0.7, 4, 0, 0, 0, -1.1, 0, 0, 0, 0;
  const double c = 0.25;
  const Matrix shifted = exponential(a + c * Matrix::Identity(4, 4));
  EXPECT_LT((shifted - std::exp(c) * exponential(a)).norm(), 1e-14 * shifted.norm());
}

} // namespace decompositions_tests
} // namespace vibroimpact
