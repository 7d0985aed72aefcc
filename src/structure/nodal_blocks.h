// Stiffness and mass while they are summed: blocks of 6 x 6, one for each node of this rank and
// each node it shares an element with. Every rank sums its rows by itself, from all elements that
// touch them: nothing need be sent.
#pragma once

#include "structure/stiffness_operator.h"

namespace vibroimpact::structure {

/// Row-major, components u, v, w, rx, ry, rz.
using NodalBlock = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

struct AssembledMatrices {
  petsc::Matrix stiffness;
  petsc::Matrix mass;
};

class NodalBlocks {
public:
  explicit NodalBlocks(const Discretisation &space);

  /// Whether an element with these nodes adds to the rows of this rank.
  bool touched_by(std::span<const int> nodes) const;
  /// The part of an element's matrices that belongs to rows of this rank.
  void add(std::span<const int> nodes, const NodalMatrix &stiffness, const NodalMatrix &mass);
  /// Of a single node; nothing happens when another rank has it.
  void add_stiffness(int node, const NodalBlock &stiffness);
  void add_mass(int node, const NodalBlock &mass);

  /// Of the free degrees of freedom. Entries that are 0 in both matrices are left out of both: in
  /// flat bodies along the axes that is half of them. Collective.
  AssembledMatrices matrices(const FreeDofs &free, MPI_Comm communicator) const;
  /// Mass times a unit displacement along x, y, z of all nodes, held ones too, at the free rows of
  /// this rank; 0 in the others: size x 3 [kg].
  vibroimpact::Matrix base_inertia(const FreeDofs &free) const;

private:
  bool own(int node) const { return row_of_node_[node] >= 0; }
  std::size_t position(int node, int neighbour) const;
  template <class Visit> void visit_rows(const FreeDofs &free, Visit visit) const;

  std::vector<int> row_of_node_;    ///< -1 for nodes of other ranks
  std::vector<int> nodes_;          ///< of this rank, in the order of their numbers
  std::vector<std::size_t> begins_; ///< of their blocks
  std::vector<int> neighbours_;     ///< of each block, in the order of their numbers
  std::vector<NodalBlock> stiffness_;
  std::vector<NodalBlock> mass_;
};

} // namespace vibroimpact::structure
