// Impulses of several rigid contacts at once against closed forms.
#include "contact/impulses.h"
#include "common/error.h"

#include <gtest/gtest.h>

#include <random>

namespace vibroimpact::contact {
namespace impulses_tests {

Vector vector_of(std::initializer_list<double> values) {
  Vector vector(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), vector.begin());
  return vector;
}

// G of a row of balls of mass one: neighbours share a ball.
Matrix row_of_balls(Index contacts) {
  Matrix matrix = 2 * Matrix::Identity(contacts, contacts);
  for (Index i = 0; i + 1 < contacts; ++i)
    matrix(i, i + 1) = matrix(i + 1, i) = -1;
  return matrix;
}

void expect_complementary(const Matrix &matrix, const Vector &q, const Vector &x) {
  const Vector slack = matrix * x + q;
  const double size = q.cwiseAbs().maxCoeff();
  for (Index i = 0; i < q.size(); ++i) {
    EXPECT_GE(x[i], 0);
    EXPECT_GE(slack[i], -1e-10 * size);
    EXPECT_NEAR(x[i] * slack[i], 0, 1e-9 * size * (1 + x.cwiseAbs().maxCoeff()));
  }
}

TEST(ImpulsesTest, OneContact) {
  const Matrix matrix = Matrix::Constant(1, 1, 0.5);
  EXPECT_DOUBLE_EQ(newton_impulses(matrix, vector_of({-3}), vector_of({2.4}))[0], 10.8);
  EXPECT_EQ(newton_impulses(matrix, vector_of({3}), vector_of({0}))[0], 0);
  EXPECT_EQ(solve_complementarity(Matrix(0, 0), Vector(0)).size(), 0);
}

// Newton's rule for all at once: the first of n balls comes with speed 1, the others touch at rest;
// the others leave together. Momentum and energy give the speeds 2/n and 2/n - 1.
TEST(ImpulsesTest, ElasticRowOfEqualBalls) {
  for (Index balls = 2; balls <= 9; ++balls) {
    const Index n = balls - 1;
    const Vector before = -Vector::Unit(n, 0);
    const Vector p = newton_impulses(row_of_balls(n), before, Vector::Unit(n, 0));
    for (Index i = 0; i < n; ++i)
      EXPECT_NEAR(p[i], 2.0 * static_cast<double>(n - i) / static_cast<double>(balls), 1e-13);
  }
}

// A ball is struck while another one touches it on the side it leaves.
TEST(ImpulsesTest, ContactsThatArePushedApartGetNoImpulse) {
  Matrix matrix(2, 2);
  matrix << 2, 1, 1, 2;
  const Vector p = newton_impulses(matrix, vector_of({-1, 0}), vector_of({1, 0}));
  EXPECT_DOUBLE_EQ(p[0], 1);
  EXPECT_EQ(p[1], 0);
}

TEST(ImpulsesTest, TheSameContactTwice) {
  const Matrix matrix = Matrix::Constant(2, 2, 0.25);
  const Vector p = newton_impulses(matrix, vector_of({-2, -2}), vector_of({1, 1}));
  EXPECT_NEAR(p.sum(), 12, 1e-12);
  // The stronger rule wins.
  const Vector q = newton_impulses(matrix, vector_of({-2, -2}), vector_of({0, 1.5}));
  EXPECT_NEAR(q.sum(), 14, 1e-12);
  EXPECT_NEAR(q[0], 0, 1e-12);
}

TEST(ImpulsesTest, SqueezedBetweenTwoSides) {
  Matrix matrix(2, 2);
  matrix << 1, -1, -1, 1;
  EXPECT_THROW(newton_impulses(matrix, vector_of({-1, -1}), vector_of({0, 0})), NumericalError);
}

TEST(ImpulsesTest, RandomSystemsAreComplementaryAndLoseEnergy) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 500; ++trial) {
    const Index n = 1 + trial % 8;
    const Index coordinates = 1 + trial % 6; // often fewer than contacts
    Matrix rows(n, coordinates);
    Vector velocity(coordinates);
    for (double &x : rows.reshaped())
      x = normal(generator);
    for (double &x : velocity)
      x = normal(generator);
    // A side that can be left: all contacts look into one half space.
    rows.col(0) = rows.col(0).cwiseAbs();
    const Matrix matrix = rows * rows.transpose();
    Vector before = rows * velocity;
    std::vector<Index> approaching;
    for (Index i = 0; i < n; ++i)
      if (before[i] <= 0)
        approaching.push_back(i);
    if (approaching.empty())
      continue;
    const Matrix part = matrix(approaching, approaching);
    const Vector speeds = before(approaching);
    Vector wanted(speeds.size());
    for (Index i = 0; i < wanted.size(); ++i)
      wanted[i] = -0.5 * (1 + std::sin(static_cast<double>(trial + i))) * speeds[i];
    const Vector p = newton_impulses(part, speeds, wanted);
    expect_complementary(part, speeds - wanted, p);
    const Vector after = speeds + part * p;
    EXPECT_LE(p.dot(after + speeds), 1e-10);
  }
}

} // namespace impulses_tests
} // namespace vibroimpact::contact
