#include "structure/rigid_links.h"

#include "structure/linked_element.h"
#include "structure/node_sets.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

using LinkRows = Eigen::Matrix<double, Eigen::Dynamic, 6>;

std::vector<int> nodes_of(const BodyModel &model, const RigidLink &link) {
  std::vector<int> nodes;
  for (const std::string &group : link.groups)
    for (const int node : find_nodes(model.mesh, {group, {}}, "Rigid link", link.name))
      nodes.push_back(node);
  for (const NamedNode &point : model.points)
    if (point.interface.empty() &&
        std::find(link.points.begin(), link.points.end(), point.name) != link.points.end())
      nodes.push_back(point.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The ends of the lines of the members that a link names.
std::vector<std::array<int, 2>> lines_of(const BodyModel &model, const RigidLink &link,
                                         const std::vector<std::string> &member_names,
                                         const std::vector<int> &members) {
  std::vector<std::array<int, 2>> lines;
  for (std::size_t line = 0; line < members.size(); ++line)
    if (members[line] >= 0 && std::find(link.members.begin(), link.members.end(),
                                        member_names[members[line]]) != link.members.end())
      lines.push_back(model.mesh.lines[line]);
  return lines;
}

/// Of all displacements and rotations that supports hold, in terms of the motion of the master;
/// lengths in units of `size`.
LinkRows held_rows(const BodyModel &model, const std::vector<int> &nodes, double size) {
  std::vector<Eigen::Matrix<double, 1, 6>> held;
  for (const int node : nodes)
    for (int component = 0; component < 6; ++component)
      if (model.fixed[node][component])
        held.emplace_back(rigid_motion((model.mesh.nodes[node] - model.mesh.nodes[nodes[0]]) / size)
                              .row(component));
  LinkRows rows(static_cast<Index>(held.size()), 6);
  for (std::size_t i = 0; i < held.size(); ++i)
    rows.row(static_cast<Index>(i)) = held[i];
  return rows;
}

struct HeldMotion {
  std::array<bool, 6> zero{};                 ///< coordinates of the master
  NodeMotion motion = NodeMotion::Identity(); ///< of the master
};

/// Gauss-Jordan elimination with full pivoting: the component of each pivot follows from those that
/// are left. What is left below the tolerance is rounding: the same is held twice.
std::vector<Index> eliminate_rows(LinkRows &rows) {
  constexpr double tolerance = 1e-9;
  std::vector<Index> pivots; // column of each row
  for (Index done = 0; done < rows.rows(); ++done) {
    Index row = 0;
    Index column = 0;
    if (rows.bottomRows(rows.rows() - done).cwiseAbs().maxCoeff(&row, &column) < tolerance)
      break;
    rows.row(done).swap(rows.row(done + row));
    rows.row(done) /= rows(done, column);
    for (Index other = 0; other < rows.rows(); ++other)
      if (other != done)
        rows.row(other) -= rows(other, column) * rows.row(done);
    pivots.push_back(column);
  }
  return pivots;
}

HeldMotion held_motion(const BodyModel &model, const std::vector<int> &nodes) {
  double size = 0;
  for (const int node : nodes)
    size = std::max(size, (model.mesh.nodes[node] - model.mesh.nodes[nodes[0]]).norm());
  const std::array<double, 2> unit{size > 0 ? size : 1, 1}; // of displacements and rotations
  LinkRows rows = held_rows(model, nodes, unit[0]);
  const std::vector<Index> pivots = eliminate_rows(rows);
  HeldMotion held;
  for (const Index column : pivots)
    held.zero[column] = true;
  for (std::size_t p = 0; p < pivots.size(); ++p)
    for (Index other = 0; other < 6; ++other)
      if (!held.zero[other])
        held.motion(pivots[p], other) =
            -rows(static_cast<Index>(p), other) * unit[pivots[p] / 3] / unit[other / 3];
  return held;
}

/// Springs along and about the axes at one node.
class NodeSprings : public Element {
public:
  NodeSprings(int node, const std::array<double, 6> &springs) : node_(node), springs_(springs) {}
  std::span<const int> nodes() const override { return {&node_, 1}; }
  NodalMatrix stiffness() const override {
    return Eigen::Map<const Eigen::Matrix<double, 6, 1>>(springs_.data()).asDiagonal();
  }
  NodalMatrix mass() const override { return NodalMatrix::Zero(6, 6); }
  NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness,
                    const NodalMatrix &u) const override {
    return stiffness * u;
  }
  Matrix stress(int /*node*/) const override { return {}; }
  double total_mass() const override { return 0; }

private:
  int node_;
  std::array<double, 6> springs_;
};

} // namespace

NodeMotion rigid_motion(const Vector3 &arm) {
  NodeMotion motion = NodeMotion::Identity();
  for (int axis = 0; axis < 3; ++axis)
    motion.block<3, 1>(0, 3 + axis) = Vector3::Unit(axis).cross(arm);
  return motion;
}

std::vector<std::vector<int>> rigid_bodies(const BodyModel &model,
                                           const std::vector<RigidLink> &links,
                                           const std::vector<std::string> &member_names,
                                           const std::vector<int> &members) {
  NodeSets sets(model.mesh.nodes.size());
  for (const RigidLink &link : links) {
    const std::vector<int> nodes = nodes_of(model, link);
    const auto lines = lines_of(model, link, member_names, members);
    if (nodes.size() == 1 || nodes.size() + lines.size() == 0)
      throw DefinitionError("Rigid link", link.name, "",
                            nodes.empty() ? "At, Points or Members must name what is rigid"
                                          : "At and Points must name at least two nodes together");
    for (const int node : nodes)
      sets.join(nodes[0], node);
    for (const auto &[first, second] : lines)
      sets.join(first, second);
  }
  return sets.joined();
}

Elimination eliminate(const BodyModel &model) {
  Elimination elimination{.nodes = {}, .zero = model.fixed};
  for (const std::vector<int> &nodes : model.rigid) {
    const int master = nodes[0];
    const HeldMotion held = held_motion(model, nodes);
    for (const int node : nodes) {
      const Vector3 arm = model.mesh.nodes[node] - model.mesh.nodes[master];
      elimination.nodes[node] = {master, rigid_motion(arm) * held.motion};
      elimination.zero[node].fill(true);
    }
    elimination.zero[master] = held.zero;
  }
  return elimination;
}

Elements eliminated_elements(const BodyModel &model, const Elimination &elimination) {
  const auto linked = [&](int node) { return elimination.nodes.contains(node); };
  Elements elements = model.elements;
  for (const auto &[node, motion] : elimination.nodes)
    if (model.spring[node] != std::array<double, 6>{})
      elements.push_back(std::make_shared<NodeSprings>(node, model.spring[node]));
  for (std::shared_ptr<const Element> &element : elements)
    if (const auto nodes = element->nodes(); std::any_of(nodes.begin(), nodes.end(), linked))
      element = std::make_shared<LinkedElement>(element, elimination);
  return elements;
}

std::map<int, LumpedMass> eliminated_masses(const BodyModel &model,
                                            const Elimination &elimination) {
  std::map<int, LumpedMass> masses;
  for (const auto &[node, mass] : model.lumped_masses) {
    const auto found = elimination.nodes.find(node);
    const LinkedNode linked =
        found == elimination.nodes.end() ? LinkedNode{.master = node} : found->second;
    const LumpedMass moved = linked.motion.transpose() * mass * linked.motion;
    masses.try_emplace(linked.master, LumpedMass::Zero()).first->second +=
        (moved + moved.transpose()) / 2;
  }
  return masses;
}

} // namespace vibroimpact::structure
