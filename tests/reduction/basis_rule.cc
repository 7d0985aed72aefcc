#include "reduction/basis_rule.h"
#include "common/decompositions.h"

#include <gtest/gtest.h>

namespace basis_rule_tests {

using namespace vibroimpact;
using vibroimpact::reduction::fix_basis;
using vibroimpact::reduction::merge_multiple;

namespace {

// Six components of four nodes.
Matrix shapes(Index columns) {
  Matrix shape(24, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < 24; ++i)
      shape(i, j) = std::sin(1.0 + 0.7 * static_cast<double>(i) + 1.3 * static_cast<double>(i * j));
  return shape;
}

Matrix rotation(Index size) {
  return orthonormalised(shapes(size).topRows(size), Basis::whole).basis;
}

} // namespace

TEST(BasisRule, SingleModesArePositiveAtTheFirstPoint) {
  Matrix shape = shapes(3);
  shape.row(12) << -1, 2, -3;
  fix_basis(Vector::LinSpaced(3, 1, 3), {2, 0}, 0, shape);
  EXPECT_EQ(shape.row(12), RowVector(Vector3(1, 2, 3).transpose()));
}

TEST(BasisRule, InsignificantRowsDoNotDecide) {
  Matrix shape = shapes(1);
  shape(12, 0) = -1e-9;
  shape(13, 0) = 0.5;
  fix_basis(Vector::Ones(1), {2}, 0, shape);
  EXPECT_EQ(shape(13, 0), 0.5);
  EXPECT_EQ(shape(12, 0), -1e-9);
}

TEST(BasisRule, DisplacementsAndRotationsHaveTheirOwnScale) {
  Matrix shape = Matrix::Constant(24, 1, -1e-6);
  for (Index node = 0; node < 4; ++node)
    shape.block(6 * node + 3, 0, 3, 1).setConstant(1);
  fix_basis(Vector::Ones(1), {0}, 0, shape);
  EXPECT_GT(shape(0, 0), 0);
}

// A point at the end of a rigid link that does not turn in a pair of modes.
TEST(BasisRule, WhatErrorsLeaveOfAKindDoesNotDecide) {
  Matrix one = shapes(2);
  for (Index node = 0; node < 4; ++node)
    one.block(6 * node + 3, 0, 3, 2).setZero();
  one.topRows(3).setZero();
  Matrix other = one * rotation(2);
  one.middleRows(3, 3) << 3e-8, 1e-8, -2e-8, 5e-9, 1e-8, 2e-8;
  other.middleRows(3, 3) << -1e-8, 3e-8, 4e-8, 1e-8, -2e-8, 1e-8;
  fix_basis(Vector::Ones(2), {0}, 1, one);
  fix_basis(Vector::Ones(2), {0}, 1, other);
  EXPECT_LT((one - other).norm(), 1e-6);
}

TEST(BasisRule, PointRowsOfAGroupBecomeLowerTriangular) {
  Matrix shape = shapes(3);
  const Matrix before = shape;
  fix_basis(Vector::Constant(3, 7.0), {1}, 0, shape);
  const Matrix rows = shape.middleRows(6, 3);
  for (Index i = 0; i < 3; ++i) {
    EXPECT_GT(rows(i, i), 0);
    for (Index j = i + 1; j < 3; ++j)
      EXPECT_NEAR(rows(i, j), 0, 1e-14);
  }
  EXPECT_LT((shape * shape.transpose() - before * before.transpose()).norm(), 1e-13);
}

TEST(BasisRule, AnyBasisOfAGroupGivesTheSameResult) {
  const Vector eigenvalues = (Vector(5) << 1, 4, 4, 4 + 1e-12, 9).finished();
  Matrix one = shapes(5);
  Matrix other = one;
  other.middleCols(1, 3) = (other.middleCols(1, 3) * rotation(3)).eval();
  other.col(0) *= -1;
  fix_basis(eigenvalues, {3}, 0, one);
  fix_basis(eigenvalues, {3}, 0, other);
  EXPECT_LT((one - other).norm(), 1e-13);
}

TEST(BasisRule, NodesDecideWhereThereAreNoPoints) {
  Matrix one = shapes(2);
  Matrix other = one * rotation(2);
  fix_basis(Vector::Zero(2), {}, 0, one);
  fix_basis(Vector::Zero(2), {}, 0, other);
  EXPECT_LT((one - other).norm(), 1e-13);
}

TEST(BasisRule, OnlyEqualEigenvaluesAreMerged) {
  const Vector merged = merge_multiple((Vector(4) << 0, 0, 4, 4 + 4e-12).finished());
  EXPECT_EQ(merged[0], 0);
  EXPECT_EQ(merged[2], merged[3]);
  const Vector apart = (Vector(2) << 4, 4 + 1e-7).finished();
  EXPECT_EQ(merge_multiple(apart), apart);
}

} // namespace basis_rule_tests
