// Coordinates in which a matrix is block-diagonal: that they are, for bodies that move freely in
// more than one way and are held by dampers and springs to each other.
#include "motion/phase/modal_form.h"
#include "common/decompositions.h"

#include <gtest/gtest.h>

#include <random>

namespace vibroimpact::motion {
namespace {

/// (0, 1; -K, -C) of `size` coordinates, of which `free` combinations meet neither springs nor
/// dampers, in coordinates turned at random: K and C have a null space but for rounding.
Matrix free_system(Index size, Index free, std::mt19937_64 &random) {
  std::normal_distribution<double> normal;
  const auto filled = [&](Index rows, Index columns) {
    return Matrix(Matrix::NullaryExpr(rows, columns, [&] { return normal(random); }));
  };
  const Matrix turned = orthonormalised(filled(size, size), Basis::whole).basis;
  const Matrix held = turned.leftCols(size - free);
  const Matrix springs = 300 * filled(size - free, size - free);
  const Matrix dampers = filled(size - free, size - free);
  Matrix matrix = Matrix::Zero(2 * size, 2 * size);
  matrix.topRightCorner(size, size).setIdentity();
  matrix.bottomLeftCorner(size, size) = -held * springs * springs.transpose() * held.transpose();
  matrix.bottomRightCorner(size, size) = -held * dampers * dampers.transpose() * held.transpose();
  return matrix;
}

/// |A W - W B| over |A| |W|, with B of the blocks.
double left_over(const Matrix &matrix, const ModalForm &form) {
  Matrix blocks = Matrix::Zero(matrix.rows(), matrix.rows());
  for (const ModalBlock &block : form.blocks())
    blocks.block(block.column, block.column, block.size, block.size) = block.matrix();
  return (matrix * form.basis() - form.basis() * blocks).norm() /
         (matrix.norm() * form.basis().norm());
}

} // namespace

// Four eigenvalues are zero, and rounding makes of them what it likes: no two of them that happen
// to have nearly parallel eigenvectors need be a block.
TEST(ModalFormTest, BlocksOfBodiesThatMoveFreely) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const Index free = 1 + trial % 3;
    const Matrix matrix = free_system(free + 1 + trial % 4, free, random);
    const ModalForm form(matrix);
    EXPECT_LT(left_over(matrix, form), 1e-13) << "trial " << trial;
    const Matrix unity = form.basis() * form.inverse();
    EXPECT_LT((unity - Matrix::Identity(matrix.rows(), matrix.rows())).norm(), 1e-10)
        << "trial " << trial;
  }
}

} // namespace vibroimpact::motion
