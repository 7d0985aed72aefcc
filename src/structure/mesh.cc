#include "structure/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace vibroimpact::structure {

namespace {

// Coordinates in a parameter file are typed by hand, so they meet a node within this fraction of
// the body's extent, far below any useful element length.
constexpr double node_tolerance = 1e-6;

std::string known_groups(const Mesh &mesh) {
  std::string list;
  for (const auto &[group, nodes] : mesh.groups)
    list += group + ", ";
  return list + "all";
}

} // namespace

std::string coordinates(const Vector3 &position) {
  std::ostringstream text;
  text << "(" << position[0] << ", " << position[1] << ", " << position[2] << ") m";
  return text.str();
}

double Mesh::extent() const {
  if (nodes.empty())
    return 0;
  Vector3 lower = nodes.front();
  Vector3 upper = nodes.front();
  for (const Vector3 &node : places()) {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  return (upper - lower).norm();
}

int Mesh::nearest_node(const Vector3 &position) const {
  const auto closer = [&](const Vector3 &a, const Vector3 &b) {
    return (a - position).squaredNorm() < (b - position).squaredNorm();
  };
  const std::span<const Vector3> all = places();
  return static_cast<int>(std::min_element(all.begin(), all.end(), closer) - all.begin());
}

double Mesh::line_length(std::size_t line) const {
  return (nodes[lines[line][1]] - nodes[lines[line][0]]).norm();
}

namespace {

/// Fractions of the length at which the line has nodes: the places divide it into pieces, each of
/// as few equal elements as keep these short enough.
std::vector<double> line_nodes(const Line &line) {
  const double length = (line.end - line.start).norm();
  std::vector<double> ends = {0, 1};
  for (const double place : line.places)
    ends.push_back(place / length);
  std::sort(ends.begin(), ends.end());
  std::vector<double> nodes = {0};
  for (const double end : ends) {
    const double begin = nodes.back();
    if (end - begin <= node_tolerance)
      continue;
    const int count =
        std::max(1, static_cast<int>(std::ceil((end - begin) * line.elements - node_tolerance)));
    for (int i = 1; i < count; ++i)
      nodes.push_back(begin + (end - begin) * i / count);
    nodes.push_back(end);
  }
  nodes.back() = 1;
  return nodes;
}

} // namespace

Mesh generate_line(const Line &line) {
  if (line.elements < 1)
    throw DefinitionError("Geometry", "", "Elements", "must be at least 1");
  if ((line.end - line.start).norm() == 0)
    throw DefinitionError("Geometry", "", "Line", "must have two different ends");
  Mesh mesh;
  for (const double along : line_nodes(line))
    mesh.nodes.emplace_back((1 - along) * line.start + along * line.end);
  const int elements = static_cast<int>(mesh.nodes.size()) - 1;
  for (int i = 0; i < elements; ++i)
    mesh.lines.push_back({i, i + 1});
  mesh.groups["start"] = {0};
  mesh.groups["end"] = {elements};
  return mesh;
}

namespace {

int numbered_node(const Mesh &mesh, int number, const std::string &kind, const std::string &name) {
  if (mesh.numbers.empty())
    throw DefinitionError(kind, name, "Node",
                          "must not be set for a body whose nodes have no numbers; only Type = "
                          "matrices has");
  const auto found = mesh.numbers.find(number);
  if (found == mesh.numbers.end())
    throw DefinitionError(
        kind, name, "Node",
        "must be the number of a node of the body with coordinates; they go from " +
            std::to_string(mesh.numbers.begin()->first) + " to " +
            std::to_string(mesh.numbers.rbegin()->first));
  return found->second;
}

} // namespace

std::vector<int> find_nodes(const Mesh &mesh, const Location &at, const std::string &kind,
                            const std::string &name) {
  if (at.number)
    return {numbered_node(mesh, *at.number, kind, name)};
  if (at.position) {
    const int nearest = mesh.nearest_node(*at.position);
    const double distance = (mesh.nodes[nearest] - *at.position).norm();
    if (!at.nearest && distance > node_tolerance * mesh.extent())
      throw DefinitionError(kind, name, "Position",
                            "must be the coordinates of a node; the nearest one is at " +
                                coordinates(mesh.nodes[nearest]));
    return {nearest};
  }
  if (at.group == "all") {
    std::vector<int> everything(mesh.places().size());
    std::iota(everything.begin(), everything.end(), 0);
    return everything;
  }
  const auto found = mesh.groups.find(at.group);
  if (found == mesh.groups.end())
    throw DefinitionError(kind, name, "At", "must be one of: " + known_groups(mesh));
  return found->second;
}

std::vector<int> find_cells(const std::map<std::string, std::vector<int>> &groups,
                            const std::string &group, std::size_t count, const std::string &kind,
                            const std::string &name) {
  if (group == "all") {
    std::vector<int> everything(count);
    std::iota(everything.begin(), everything.end(), 0);
    return everything;
  }
  const auto found = groups.find(group);
  if (found == groups.end()) {
    std::string known;
    for (const auto &[known_group, cells] : groups)
      known += known_group + ", ";
    throw DefinitionError(kind, name, "On", "must be one of: " + known + "all");
  }
  return found->second;
}

} // namespace vibroimpact::structure
