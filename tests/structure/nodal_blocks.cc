// Sums of element matrices by nodes, with matrices made up so that every entry shows where it went.
#include "structure/nodal_blocks.h"

#include <gtest/gtest.h>

#include <array>

namespace nodal_blocks_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;

namespace {

double mass_entry(int i, int j) { return 1.0 / (1 + i + j); }

/// Two nodes; the last rotation of the second one is held.
struct Pair {
  Discretisation space;
  FreeDofs free;
  NodalMatrix stiffness = NodalMatrix::Identity(12, 12);
  NodalMatrix mass = NodalMatrix::NullaryExpr(12, 12, [](Index i, Index j) {
    return mass_entry(static_cast<int>(i), static_cast<int>(j));
  });

  Pair() {
    space.neighbours = {{0, 1}, {0, 1}};
    space.own_end = 12;
    for (int node = 0; node < 2; ++node)
      space.dofs.push_back(
          {6 * node, 6 * node + 1, 6 * node + 2, 6 * node + 3, 6 * node + 4, 6 * node + 5});
    free.number = space.dofs;
    free.number[1][5] = -1;
    free.size = free.own_end = 11;
  }

  NodalBlocks blocks() const {
    NodalBlocks blocks(space);
    blocks.add(std::array{0, 1}, stiffness, mass);
    return blocks;
  }
};

double entry(Mat matrix, int i, int j) {
  double value = 0;
  MatGetValues(matrix, 1, &i, 1, &j, &value);
  return value;
}

} // namespace

// The stiffness is diagonal, the mass is not: no entry of either may be lost.
TEST(NodalBlocks, KeepWhatIsZeroInOneMatrixOnly) {
  const Pair pair;
  const AssembledMatrices matrices = pair.blocks().matrices(pair.free, MPI_COMM_SELF);
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 11; ++j) {
      EXPECT_EQ(entry(matrices.stiffness.get(), i, j), i == j ? 1 : 0);
      EXPECT_EQ(entry(matrices.mass.get(), i, j), mass_entry(i, j));
    }
}

TEST(NodalBlocks, AddWhatBelongsToANode) {
  const Pair pair;
  NodalBlocks blocks = pair.blocks();
  blocks.add_stiffness(1, 3 * NodalBlock::Identity());
  blocks.add_mass(0, 5 * NodalBlock::Identity());
  const AssembledMatrices matrices = blocks.matrices(pair.free, MPI_COMM_SELF);
  EXPECT_EQ(entry(matrices.stiffness.get(), 6, 6), 4);
  EXPECT_EQ(entry(matrices.stiffness.get(), 0, 0), 1);
  EXPECT_EQ(entry(matrices.mass.get(), 0, 0), 6);
}

TEST(NodalBlocks, BaseInertiaCountsHeldDisplacements) {
  Pair pair;
  pair.free.number[1] = {6, -1, 7, 8, 9, 10};
  const Matrix inertia = pair.blocks().base_inertia(pair.free);
  for (int row = 0; row < 6; ++row)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(inertia(row, axis), mass_entry(row, axis) + mass_entry(row, 6 + axis), 1e-15);
}

} // namespace nodal_blocks_tests
