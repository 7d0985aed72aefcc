#include "structure/line_mesh.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace vibroimpact::structure {

namespace {

// Coordinates in a parameter file are typed by hand, so they meet a node within this fraction of
// the body's extent, far below any useful element length.
constexpr double position_tolerance = 1e-6;

std::string coordinates(const Vector3 &position) {
  std::ostringstream text;
  text << "(" << position[0] << ", " << position[1] << ", " << position[2] << ") m";
  return text.str();
}

int root_of(std::vector<int> &parent, int node) {
  while (parent[node] != node)
    node = parent[node] = parent[parent[node]];
  return node;
}

int count_parts(const LineMesh &mesh) {
  std::vector<int> parent(mesh.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  int parts = static_cast<int>(mesh.nodes.size());
  for (const auto &cell : mesh.cells) {
    const int first = root_of(parent, cell[0]);
    const int second = root_of(parent, cell[1]);
    if (first != second)
      --parts;
    parent[first] = second;
  }
  return parts;
}

std::string known_groups(const LineMesh &mesh) {
  std::string list;
  for (const auto &[group, nodes] : mesh.groups)
    list += group + ", ";
  return list + "all";
}

} // namespace

double LineMesh::extent() const {
  if (nodes.empty())
    return 0;
  Vector3 lower = nodes.front();
  Vector3 upper = nodes.front();
  for (const Vector3 &node : nodes) {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  return (upper - lower).norm();
}

int LineMesh::nearest_node(const Vector3 &position) const {
  const auto closer = [&](const Vector3 &a, const Vector3 &b) {
    return (a - position).squaredNorm() < (b - position).squaredNorm();
  };
  return static_cast<int>(std::min_element(nodes.begin(), nodes.end(), closer) - nodes.begin());
}

double LineMesh::cell_length(std::size_t cell) const {
  return (nodes[cells[cell][1]] - nodes[cells[cell][0]]).norm();
}

LineMesh generate_line(const Line &line) {
  if (line.elements < 1)
    throw DefinitionError("Geometry", "", "Elements", "must be at least 1");
  if ((line.end - line.start).norm() == 0)
    throw DefinitionError("Geometry", "", "Line", "must have two different ends");
  LineMesh mesh;
  for (int i = 0; i <= line.elements; ++i) {
    const double along = static_cast<double>(i) / line.elements;
    mesh.nodes.emplace_back((1 - along) * line.start + along * line.end);
  }
  for (int i = 0; i < line.elements; ++i)
    mesh.cells.push_back({i, i + 1});
  mesh.groups["start"] = {0};
  mesh.groups["end"] = {line.elements};
  return mesh;
}

void check_mesh(const LineMesh &mesh) {
  if (mesh.cells.empty())
    throw DefinitionError("Geometry", "", "Mesh", "must hold line cells, but has none");
  const double smallest = 1e-12 * mesh.extent();
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.cell_length(cell) <= smallest)
      throw DefinitionError("Geometry", "", "Mesh",
                            "must have cells of positive length, but the one at " +
                                coordinates(mesh.nodes[mesh.cells[cell][0]]) + " has none");
  const int parts = count_parts(mesh);
  if (parts > 1)
    throw DefinitionError("Geometry", "", "Mesh",
                          "must be one connected body, but has " + std::to_string(parts) +
                              " parts that share no node (coincident nodes must be merged)");
}

std::vector<int> find_nodes(const LineMesh &mesh, const Location &at, const std::string &kind,
                            const std::string &name) {
  if (at.position) {
    const int nearest = mesh.nearest_node(*at.position);
    if ((mesh.nodes[nearest] - *at.position).norm() > position_tolerance * mesh.extent())
      throw DefinitionError(kind, name, "Position",
                            "must be the coordinates of a node; the nearest one is at " +
                                coordinates(mesh.nodes[nearest]));
    return {nearest};
  }
  if (at.group == "all") {
    std::vector<int> everything(mesh.nodes.size());
    std::iota(everything.begin(), everything.end(), 0);
    return everything;
  }
  const auto found = mesh.groups.find(at.group);
  if (found == mesh.groups.end())
    throw DefinitionError(kind, name, "At", "must be one of: " + known_groups(mesh));
  return found->second;
}

} // namespace vibroimpact::structure
