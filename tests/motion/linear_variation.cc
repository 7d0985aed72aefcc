// Closed forms of deviations in linear phases: against the exponential of one matrix for all.
#include "common/decompositions.h"
#include "motion/variation/forced_response.h"
#include "motion/variation/low_rank_map.h"
#include "motion/variation/radau.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vibroimpact::motion {
namespace linear_variation_tests {

PhaseGroup pair(Complex exponent, Index first) {
  return {.kind = BlockKind::pair,
          .exponent = exponent,
          .coordinates = {first, first + 1},
          .generator = pair_generator(exponent)};
}

PhaseGroup real(double exponent, Index first) {
  return {.kind = BlockKind::real,
          .exponent = exponent,
          .coordinates = {first},
          .generator = Matrix::Constant(1, 1, exponent)};
}

// A free body: a double zero.
PhaseGroup free_body(Index first) {
  Matrix generator(2, 2);
  generator << 0, 1, 0, 0;
  return {.kind = BlockKind::dense, .coordinates = {first, first + 1}, .generator = generator};
}

Matrix generator_of(const std::vector<PhaseGroup> &groups, Index size) {
  Matrix all = Matrix::Zero(size, size);
  for (const PhaseGroup &group : groups)
    all(group.coordinates, group.coordinates) = group.generator;
  return all;
}

Matrix random_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  return Matrix::NullaryExpr(rows, columns, [&] { return number(generator); });
}

// The derivative of exp((D + e E) h) (x + e dx) by e at zero is a block of exp([D E; 0 D] h).
double error_of(const std::vector<PhaseGroup> &groups, Index size, double h) {
  const Matrix coupling = random_matrix(size, size, 1);
  const Vector x = random_matrix(size, 1, 2);
  const Vector start = random_matrix(size, 1, 3);
  const Matrix own = generator_of(groups, size);
  Matrix all = Matrix::Zero(2 * size, 2 * size);
  all << own, coupling, Matrix::Zero(size, size), own;
  Vector both(2 * size);
  both << start, x;
  const Vector exact = (exponential(h * all) * both).head(size);
  return (ForcedResponse(groups, coupling)(h, x, start) - exact).norm() / exact.norm();
}

TEST(LinearVariationTest, PairsAndRealCoordinatesFarApart) {
  const std::vector<PhaseGroup> groups = {pair({-0.3, 5}, 0), pair({-0.1, 17}, 2), real(-2, 4),
                                          real(0, 5)};
  for (const double h : {1e-3, 0.1, 1.0})
    EXPECT_LT(error_of(groups, 6, h), 1e-13) << h;
}

// Where the difference of two exponentials over that of their exponents would be 0/0.
TEST(LinearVariationTest, EqualAndNearlyEqualExponents) {
  for (const double apart : {0.0, 1e-13, 1e-9, 1e-5, 1e-2}) {
    const std::vector<PhaseGroup> groups = {pair({-0.3, 5}, 0), pair({-0.3, 5 + apart}, 2),
                                            real(-0.3, 4), real(-0.3 + apart, 5)};
    EXPECT_LT(error_of(groups, 6, 1.0), 1e-13) << apart;
  }
}

TEST(LinearVariationTest, FreeBodiesBesideVibrations) {
  const std::vector<PhaseGroup> groups = {pair({-0.1, 6}, 0), real(-1, 2), free_body(3),
                                          free_body(5)};
  for (const double h : {1e-3, 0.1, 1.0})
    EXPECT_LT(error_of(groups, 7, h), 1e-13) << h;
}

TEST(LinearVariationTest, MapsOfLowRankAreThoseOfTheirMatrices) {
  const Matrix left = random_matrix(6, 2, 4);
  const Matrix right = random_matrix(2, 6, 5);
  LowRankMap map;
  for (Index k = 0; k < 2; ++k)
    map.add(left.col(k), right.row(k));
  const Matrix full = Matrix::Identity(6, 6) + left * right;
  Matrix columns = random_matrix(6, 3, 6);
  const Matrix expected = full * columns;
  map.apply(columns);
  EXPECT_LT((columns - expected).norm(), 1e-14);
  RowVector row = random_matrix(1, 6, 7);
  const RowVector expected_row = row * full;
  map.apply_from_right(row);
  EXPECT_LT((row - expected_row).norm(), 1e-14);
  EXPECT_NEAR(map.determinant(), determinant(full), 1e-14);
}

// Radau IIA with two stages is in every book; quadrature with s stages is exact to degree 2 s - 2.
TEST(LinearVariationTest, RadauMethods) {
  const RadauMethod two(2);
  Matrix book(2, 2);
  book << 5.0 / 12, -1.0 / 12, 3.0 / 4, 1.0 / 4;
  EXPECT_LT((two.coefficients - book).norm(), 1e-15);
  for (const Index stages : {2, 5, 7}) {
    const RadauMethod method(stages);
    for (Index degree = 0; degree <= 2 * stages - 2; ++degree) {
      double sum = 0;
      for (Index j = 0; j < stages; ++j)
        sum += method.coefficients(stages - 1, j) *
               std::pow(method.nodes[j], static_cast<double>(degree));
      EXPECT_NEAR(sum, 1 / static_cast<double>(degree + 1), 1e-14) << stages << " " << degree;
    }
  }
}

} // namespace linear_variation_tests
} // namespace vibroimpact::motion
