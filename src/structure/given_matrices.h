// Stiffness, mass and damping of a body as they were given, before anything is held: rows are those
// of a table of degrees of freedom, shared out over the ranks.
#pragma once

#include "structure/dof_table.h"
#include "structure/matrix_definition.h"
#include "structure/matrix_file.h"
#include "structure/sparse_rows.h"

#include <mpi.h>

#include <array>

namespace vibroimpact::structure {

struct GivenMatrices {
  int size = 0;      ///< rows of all ranks
  int own_begin = 0; ///< this rank has the rows own_begin <= row < own_end
  int own_end = 0;
  /// Node (position in the list of the mesh) and component of each row, on every rank.
  std::vector<std::array<int, 2>> place{};
  SparseRows rows{};               ///< with the whole diagonal
  std::vector<double> stiffness{}; ///< [N/m, N, N m]
  std::vector<double> mass{};      ///< [kg, kg m, kg m^2]; entries as in the stiffness
  SparseRows damping_rows{};       ///< no rows without damping
  std::vector<double> damping{};   ///< [N s/m, N s, N m s]

  bool damped() const { return damping_rows.begins.size() > 1; }
  bool own(int row) const { return row >= own_begin && row < own_end; }
};

/// Several rows of one node and component are given: the nodes at which CalculiX expands a shell or
/// a beam keep its number. Their mean stands in the place of the first of them, for the others
/// stands what they differ from it by: u_k = m + d_k, and the first is u_1 = m - sum d_k. The
/// motion is the same, and a force on the mean is shared equally.
struct RowGroups {
  std::vector<int> first;               ///< of each row, the first row of its node and component
  std::vector<std::vector<int>> others; ///< by row: those behind the first, for the first alone
  bool any = false;
};
RowGroups group_rows(const std::vector<TableRow> &table);

/// Reads the files of the definition and checks them: sizes, symmetry, signs. `place` stays empty.
/// Collective. Throws DefinitionError.
GivenMatrices read_given_matrices(const MatrixDefinition &definition,
                                  const std::vector<TableRow> &table, const RowGroups &groups,
                                  MPI_Comm communicator);

} // namespace vibroimpact::structure
