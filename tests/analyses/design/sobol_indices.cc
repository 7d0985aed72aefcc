// Sobol's indices of functions whose indices are known.
#include "analyses/design/sobol_indices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {
namespace sobol_indices_tests {

using Function = std::function<double(const Vector &)>;

std::vector<double> values_of(const Function &function, const SobolDesign &design) {
  std::vector<double> values;
  for (std::size_t i = 0; i < design.points(); ++i)
    values.push_back(function(design.point(i)));
  return values;
}

SobolIndices indices_of(const Function &function, Index arguments, std::size_t rows,
                        std::uint64_t seed = 1) {
  return sobol_indices(values_of(function, {rows, arguments, seed}), arguments, seed);
}

// sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1 on (-pi, pi)^3, whose variance is
// 7^2/8 + 0.1 pi^4/5 + 0.01 pi^8/18 + 1/2 (Ishigami and Homma).
double ishigami(const Vector &u) {
  const Vector x = (2 * u.array() - 1) * std::numbers::pi;
  return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) +
         0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

TEST(SobolIndicesTest, IshigamiWithinTheStandardErrors) {
  const double pi4 = std::pow(std::numbers::pi, 4);
  const double variance = 49.0 / 8 + 0.1 * pi4 / 5 + 0.01 * pi4 * pi4 / 18 + 0.5;
  const double first[] = {0.5 * std::pow(1 + 0.1 * pi4 / 5, 2) / variance, 49.0 / 8 / variance, 0};
  const double together = 0.01 * pi4 * pi4 * (1.0 / 18 - 1.0 / 50) / variance; // of x1 and x3
  const double total[] = {first[0] + together, first[1], together};
  int beyond_two = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SobolIndices found = indices_of(ishigami, 3, 2000, seed);
    EXPECT_NEAR(found.mean, 3.5, 0.3);
    EXPECT_NEAR(found.variance, variance, 1.5);
    for (std::size_t i = 0; i < 3; ++i) {
      const SobolIndex &index = found.arguments[i];
      EXPECT_NEAR(index.first, first[i], 4 * index.first_error) << seed;
      EXPECT_NEAR(index.total, total[i], 4 * index.total_error) << seed;
      EXPECT_LT(index.total_error, 0.04);
      beyond_two += std::abs(index.first - first[i]) > 2 * index.first_error ? 1 : 0;
      beyond_two += std::abs(index.total - total[i]) > 2 * index.total_error ? 1 : 0;
    }
  }
  // Of 60 values some 3 lie beyond two standard errors: 0.1 % of cases have more than 9.
  EXPECT_LE(beyond_two, 9);
}

// The error of an estimate over many seeds is what the bootstrap of one says.
TEST(SobolIndicesTest, StandardErrorsAreTheScatterOverSeeds) {
  double sum = 0, squares = 0, errors = 0;
  const int seeds = 60;
  for (int seed = 0; seed < seeds; ++seed) {
    const SobolIndex index =
        indices_of(ishigami, 3, 200, static_cast<std::uint64_t>(seed)).arguments[0];
    sum += index.total;
    squares += index.total * index.total;
    errors += index.total_error;
  }
  const double scatter = std::sqrt((squares - sum * sum / seeds) / (seeds - 1));
  EXPECT_NEAR(errors / seeds / scatter, 1, 4 / std::sqrt(2.0 * seeds));
}

// A sum of independent terms has no interactions: first order and total are the variances' shares.
TEST(SobolIndicesTest, OfASumTheSharesOfTheVariance) {
  const SobolIndices found =
      indices_of([](const Vector &u) { return u[0] + 2 * u[1] + 3 * u[2]; }, 3, 4000);
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = static_cast<double>((i + 1) * (i + 1)) / 14;
    EXPECT_NEAR(found.arguments[i].first, share, 4 * found.arguments[i].first_error);
    EXPECT_NEAR(found.arguments[i].total, share, 4 * found.arguments[i].total_error);
  }
  EXPECT_NEAR(found.mean, 3, 0.05);
}

TEST(SobolIndicesTest, RowsWithAFailureAreLeftOut) {
  const SobolDesign design{500, 2, 1};
  const Function function = [](const Vector &u) { return u[0] + u[1]; };
  std::vector<double> values = values_of(function, design);
  values[4 * 7 + 2] = std::numeric_limits<double>::quiet_NaN();
  const SobolIndices found = sobol_indices(values, 2, 1);
  EXPECT_EQ(found.rows, 499U);
  EXPECT_NEAR(found.arguments[0].total, 0.5, 0.1);
  const SobolIndices none =
      sobol_indices(std::vector<double>(8, std::numeric_limits<double>::quiet_NaN()), 2, 1);
  EXPECT_EQ(none.rows, 0U);
  EXPECT_TRUE(std::isnan(none.mean));
}

TEST(SobolIndicesTest, AConstantHasNoIndices) {
  const SobolIndices found = indices_of([](const Vector &) { return 2.0; }, 2, 10);
  EXPECT_EQ(found.mean, 2);
  EXPECT_EQ(found.variance, 0);
  EXPECT_TRUE(std::isnan(found.arguments[0].first));
}

// Of A_B^i the column i is that of B, all others are those of A.
TEST(SobolIndicesTest, TheDesign) {
  const SobolDesign design{3, 2, 5};
  EXPECT_EQ(design.points(), 12U);
  const Vector a = design.point(4), b = design.point(5);
  EXPECT_EQ(design.point(6), (Vector(2) << b[0], a[1]).finished());
  EXPECT_EQ(design.point(7), (Vector(2) << a[0], b[1]).finished());
  EXPECT_NE(a, design.point(0));
}

} // namespace sobol_indices_tests
} // namespace vibroimpact::analyses
