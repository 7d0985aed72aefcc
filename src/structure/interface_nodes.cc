#include "structure/interface_nodes.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace vibroimpact::structure {

namespace {

// Coordinates within this fraction of the body's extent count as equal: mesh generators round.
constexpr double equal_coordinates = 1e-6;

std::vector<int> by_coordinates(const Mesh &mesh, std::vector<int> nodes) {
  const double unit = std::max(equal_coordinates * mesh.extent(), 1e-300);
  const auto key = [&](int node) {
    const Vector3 rounded = (mesh.nodes[node] / unit).array().round();
    return std::tuple(rounded[0], rounded[1], rounded[2], node);
  };
  std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return key(a) < key(b); });
  return nodes;
}

int nearest(const Mesh &mesh, const std::vector<int> &nodes, const Vector3 &position) {
  const double tolerance = equal_coordinates * mesh.extent();
  int found = nodes.front();
  for (const int node : nodes)
    if ((mesh.nodes[node] - position).norm() < (mesh.nodes[found] - position).norm() - tolerance)
      found = node;
  return found;
}

} // namespace

std::vector<int> interface_nodes(const Mesh &mesh, const Interface &interface) {
  std::vector<int> nodes = by_coordinates(
      mesh, find_nodes(mesh, {interface.group, std::nullopt}, "Interface", interface.name));
  if (nodes.empty())
    throw DefinitionError("Interface", interface.name, "At",
                          "must be a group with nodes; this one is empty");
  if (interface.near.empty())
    return nodes;
  std::vector<int> chosen;
  std::map<int, std::size_t> position_of;
  for (std::size_t i = 0; i < interface.near.size(); ++i) {
    const int node = nearest(mesh, nodes, interface.near[i]);
    const auto [other, is_new] = position_of.emplace(node, i + 1);
    if (!is_new)
      throw DefinitionError("Interface", interface.name, interface.near_key,
                            "must mean different nodes, but the one at " +
                                coordinates(mesh.nodes[node]) + " is nearest to positions " +
                                std::to_string(other->second) + " and " + std::to_string(i + 1));
    chosen.push_back(node);
  }
  return chosen;
}

} // namespace vibroimpact::structure
