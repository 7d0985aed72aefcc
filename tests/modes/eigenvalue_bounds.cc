// The quadratic bound against errors that are known: K and M diagonal, so that any Ritz value can
// be compared with its eigenvalue.
#include "modes/eigenvalue_bounds.h"
#include "common/decompositions.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace eigenvalue_bounds_tests {

using namespace vibroimpact;

namespace {

struct Errors {
  Vector bounds;
  Vector errors; // of the Ritz values, relative to the distance from the shift
};

/// Rayleigh-Ritz in the span of the first `count` unit vectors, tilted by random ones of this size.
Errors tilted(const Vector &eigenvalues, int count, double tilt, double shift, double gap) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> entry(-1, 1);
  Matrix x = Matrix::Identity(eigenvalues.size(), count);
  x += tilt * Matrix::NullaryExpr(x.rows(), count, [&] { return entry(engine); });
  x = orthonormalised(x, Basis::columns).basis;
  const SymmetricEigen ritz = symmetric_eigen(x.transpose() * eigenvalues.asDiagonal() * x);
  x = x * ritz.vectors;
  const Vector &theta = ritz.values;
  const Matrix residuals = eigenvalues.asDiagonal() * x - x * theta.asDiagonal();
  const Matrix products = residuals.transpose() *
                          (eigenvalues.array() - shift).inverse().matrix().asDiagonal() * residuals;
  const Vector exact = eigenvalues.head(count);
  return {modes::quadratic_bounds(theta, shift, gap, products),
          (theta - exact).cwiseQuotient((exact.array() - shift).matrix())};
}

} // namespace

TEST(EigenvalueBounds, AreAboveTheErrors) {
  Vector eigenvalues(40);
  for (Index j = 0; j < 40; ++j)
    eigenvalues[j] = 1.0 + 0.3 * static_cast<double>(j * j);
  for (const double tilt : {0.02, 1e-3, 1e-5})
    for (const double gap : {29.0, 30.5}) {
      const Errors found = tilted(eigenvalues, 10, tilt, -0.1, gap);
      for (Index j = 0; j < 10; ++j) {
        EXPECT_GE(found.errors[j], -1e-14);
        EXPECT_LE(found.errors[j], found.bounds[j] + 1e-14) << tilt << " " << j;
      }
    }
}

// Six equal eigenvalues, and two more behind them that differ by 1e-10.
TEST(EigenvalueBounds, HoldForMultipleEigenvalues) {
  Vector eigenvalues = Vector::LinSpaced(30, 1, 30);
  eigenvalues.head(6).setConstant(1);
  eigenvalues[7] = eigenvalues[6] + 1e-10;
  for (const double tilt : {1e-3, 1e-4}) {
    const Errors found = tilted(eigenvalues, 8, tilt, -1e-3, 8);
    EXPECT_TRUE((found.errors.array() <= found.bounds.array() + 1e-14).all());
  }
}

TEST(EigenvalueBounds, AreQuadratic) {
  const Vector eigenvalues = Vector::LinSpaced(30, 1, 30);
  const double coarse = tilted(eigenvalues, 8, 1e-5, -1e-3, 8.5).bounds.maxCoeff();
  const double fine = tilted(eigenvalues, 8, 1e-6, -1e-3, 8.5).bounds.maxCoeff();
  EXPECT_NEAR(coarse / fine, 100, 1);
}

// Two eigenvalues, one vector, shift 0: nu = 1 and 1/2, t = cos^2 + sin^2 / 2. The theorem of Kato
// and Temple is sharp there: nu_1 - t = |E|^2 / (t - nu_2).
TEST(EigenvalueBounds, AreSharpInTwoDimensions) {
  const double angle = 1e-3;
  const double theta = std::pow(std::cos(angle), 2) + 2 * std::pow(std::sin(angle), 2);
  const double first = (1 - theta) * std::cos(angle);
  const double second = (2 - theta) * std::sin(angle);
  Matrix products(1, 1);
  products << first * first + second * second / 2;
  Vector value(1);
  value << theta;
  const double bound = modes::quadratic_bounds(value, 0, 2, products)[0];
  EXPECT_GE(bound, theta - 1);
  EXPECT_NEAR(bound / (theta - 1), 1, 1e-5);
}

TEST(EigenvalueBounds, AreInfiniteBeyondTheGap) {
  Vector eigenvalues = Vector::LinSpaced(10, 1, 10);
  EXPECT_EQ(tilted(eigenvalues, 3, 1e-3, 0, 2.5).bounds[0],
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(tilted(eigenvalues, 3, 0.9, 0, 3.2).bounds[2], std::numeric_limits<double>::infinity());
}

TEST(EigenvalueBounds, NeedNoGapWhenAllEigenvaluesAreThere) {
  const Vector eigenvalues = Vector::LinSpaced(5, 1, 5);
  const Errors found = tilted(eigenvalues, 5, 0.1, -1, std::numeric_limits<double>::infinity());
  EXPECT_LT(found.bounds.maxCoeff(), 1e-25);
}

} // namespace eigenvalue_bounds_tests
