#include "structure/nodal_blocks.h"

#include "structure/sparse_rows.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

/// The coordinates of a node for a unit displacement along x, y and z. Those of a master whose
/// rigid body is held are zero where its motion follows from them.
Eigen::Matrix<double, 6, 3> unit_displacements(const FreeDofs &free, int node) {
  const auto found = free.linked.find(node);
  if (found == free.linked.end())
    return Eigen::Matrix<double, 6, 3>::Identity();
  return found->second.motion.inverse().leftCols<3>();
}

} // namespace

NodalBlocks::NodalBlocks(const Discretisation &space) : row_of_node_(space.dofs.size(), -1) {
  const auto number = [&](int node) { return space.dofs[node][0]; };
  const auto before = [&](int a, int b) { return number(a) < number(b); };
  for (std::size_t node = 0; node < space.dofs.size(); ++node)
    if (const int first = number(static_cast<int>(node));
        first >= space.own_begin && first < space.own_end)
      nodes_.push_back(static_cast<int>(node));
  std::sort(nodes_.begin(), nodes_.end(), before);
  begins_.push_back(0);
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    row_of_node_[nodes_[row]] = static_cast<int>(row);
    std::vector<int> neighbours = space.neighbours[nodes_[row]];
    std::sort(neighbours.begin(), neighbours.end(), before);
    neighbours_.insert(neighbours_.end(), neighbours.begin(), neighbours.end());
    begins_.push_back(neighbours_.size());
  }
  stiffness_.assign(neighbours_.size(), NodalBlock::Zero());
  mass_.assign(neighbours_.size(), NodalBlock::Zero());
}

std::size_t NodalBlocks::position(int node, int neighbour) const {
  const auto first = neighbours_.begin() + static_cast<std::ptrdiff_t>(begins_[row_of_node_[node]]);
  return std::find(first, neighbours_.end(), neighbour) - neighbours_.begin();
}

bool NodalBlocks::touched_by(std::span<const int> nodes) const {
  return std::any_of(nodes.begin(), nodes.end(), [&](int node) { return own(node); });
}

void NodalBlocks::add(std::span<const int> nodes, const NodalMatrix &stiffness,
                      const NodalMatrix &mass) {
  const Index size = stiffness.rows() / static_cast<Index>(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; own(nodes[i]) && j < nodes.size(); ++j) {
      const std::size_t at = position(nodes[i], nodes[j]);
      const Index row = size * static_cast<Index>(i);
      const Index column = size * static_cast<Index>(j);
      stiffness_[at].topLeftCorner(size, size) += stiffness.block(row, column, size, size);
      mass_[at].topLeftCorner(size, size) += mass.block(row, column, size, size);
    }
}

void NodalBlocks::add_stiffness(int node, const NodalBlock &stiffness) {
  if (own(node))
    stiffness_[position(node, node)] += stiffness;
}

void NodalBlocks::add_mass(int node, const NodalBlock &mass) {
  if (own(node))
    mass_[position(node, node)] += mass;
}

/// Calls visit(row, column, stiffness, mass) for all entries, row by row, in the order of columns.
template <class Visit> void NodalBlocks::visit_rows(const FreeDofs &free, Visit visit) const {
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    for (int component = 0; component < 6; ++component) {
      const int row = free.number[nodes_[n]][component];
      if (row < 0)
        continue;
      for (std::size_t at = begins_[n]; at < begins_[n + 1]; ++at)
        for (int other = 0; other < 6; ++other) {
          const int column = free.number[neighbours_[at]][other];
          const double stiffness = stiffness_[at](component, other);
          const double mass = mass_[at](component, other);
          if (column >= 0 && (stiffness != 0 || mass != 0 || column == row))
            visit(row, column, stiffness, mass);
        }
    }
}

AssembledMatrices NodalBlocks::matrices(const FreeDofs &free, MPI_Comm communicator) const {
  SparseRows pattern;
  pattern.begins.assign(free.own_end - free.own_begin + 1, 0);
  visit_rows(free,
             [&](int row, int, double, double) { ++pattern.begins[row - free.own_begin + 1]; });
  for (std::size_t row = 1; row < pattern.begins.size(); ++row)
    pattern.begins[row] += pattern.begins[row - 1];
  std::vector<double> stiffness;
  std::vector<double> mass;
  pattern.columns.reserve(pattern.begins.back());
  stiffness.reserve(pattern.begins.back());
  mass.reserve(pattern.begins.back());
  visit_rows(free, [&](int, int column, double k, double m) {
    pattern.columns.push_back(column);
    stiffness.push_back(k);
    mass.push_back(m);
  });
  return {sparse_matrix(free, pattern, stiffness, communicator),
          sparse_matrix(free, pattern, mass, communicator)};
}

vibroimpact::Matrix NodalBlocks::base_inertia(const FreeDofs &free) const {
  vibroimpact::Matrix inertia = vibroimpact::Matrix::Zero(free.size, 3);
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    for (std::size_t at = begins_[n]; at < begins_[n + 1]; ++at) {
      const Eigen::Matrix<double, 6, 3> moved =
          mass_[at] * unit_displacements(free, neighbours_[at]);
      for (int component = 0; component < 6; ++component)
        if (const int row = free.number[nodes_[n]][component]; row >= 0)
          inertia.row(row) += moved.row(component);
    }
  return inertia;
}

} // namespace vibroimpact::structure
