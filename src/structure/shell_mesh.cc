#include "structure/shell_mesh.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <set>

namespace vibroimpact::structure {

namespace {

constexpr double full_turn = 2 * M_PI;

[[noreturn]] void fail(const std::string &key, const std::string &problem) {
  throw DefinitionError("Geometry", "", key, problem);
}

/// A regular grid of nodes, mapped into space. In a closed one the first direction meets itself.
struct Grid {
  std::array<int, 2> elements;
  bool closed = false;
  CellShape shape = CellShape::quadrilateral;
  std::function<Vector3(double, double)> position; ///< of the fractions along both directions

  int columns() const { return elements[0] + (closed ? 0 : 1); }
  int node(int i, int j) const { return j * columns() + i % columns(); }
};

void add_grid_nodes(const Grid &grid, Mesh &mesh) {
  for (int j = 0; j <= grid.elements[1]; ++j)
    for (int i = 0; i < grid.columns(); ++i)
      mesh.nodes.push_back(grid.position(static_cast<double>(i) / grid.elements[0],
                                         static_cast<double>(j) / grid.elements[1]));
}

void add_surfaces(const Grid &grid, Mesh &mesh) {
  for (int j = 0; j < grid.elements[1]; ++j)
    for (int i = 0; i < grid.elements[0]; ++i) {
      const std::vector<int> c = {grid.node(i, j), grid.node(i + 1, j), grid.node(i + 1, j + 1),
                                  grid.node(i, j + 1)};
      if (grid.shape == CellShape::quadrilateral) {
        mesh.cells.push_back(cell_of(grid.shape, c));
      } else if ((i + j) % 2 == 0) { // diagonals change their direction: no direction is preferred
        mesh.cells.push_back(cell_of(grid.shape, {c[0], c[1], c[2]}));
        mesh.cells.push_back(cell_of(grid.shape, {c[0], c[2], c[3]}));
      } else {
        mesh.cells.push_back(cell_of(grid.shape, {c[0], c[1], c[3]}));
        mesh.cells.push_back(cell_of(grid.shape, {c[1], c[2], c[3]}));
      }
    }
}

/// `node(k)`, k = 0 ... count, along an edge.
void add_edge(const std::string &name, int count, const std::function<int(int)> &node, Mesh &mesh) {
  for (int k = 0; k < count; ++k)
    for (const std::string &group : {name, std::string("edges")})
      mesh.line_groups[group].push_back(static_cast<int>(mesh.lines.size()) + k);
  for (int k = 0; k < count; ++k)
    mesh.lines.push_back({node(k), node(k + 1)});
}

void add_edges(const Grid &grid, Mesh &mesh) {
  const int right = grid.elements[0];
  const int top = grid.elements[1];
  if (!grid.closed) {
    add_edge(
        "left", top, [&](int k) { return grid.node(0, k); }, mesh);
    add_edge(
        "right", top, [&](int k) { return grid.node(right, k); }, mesh);
  }
  add_edge(
      "bottom", right, [&](int k) { return grid.node(k, 0); }, mesh);
  add_edge(
      "top", right, [&](int k) { return grid.node(k, top); }, mesh);
  for (const auto &[name, lines] : mesh.line_groups) {
    std::set<int> nodes;
    for (const int line : lines)
      nodes.insert(mesh.lines[line].begin(), mesh.lines[line].end());
    mesh.groups[name].assign(nodes.begin(), nodes.end());
  }
}

Mesh generate(const Grid &grid) {
  if (grid.elements[0] < 1 || grid.elements[1] < 1)
    fail("Divisions", "must be at least 1 in each direction");
  if (grid.closed && grid.elements[0] < 3)
    fail("Divisions", "must be at least 3 around a closed cylinder");
  Mesh mesh;
  add_grid_nodes(grid, mesh);
  add_surfaces(grid, mesh);
  add_edges(grid, mesh);
  return mesh;
}

} // namespace

Mesh generate_plate(const Plate &plate) {
  const Vector3 first = plate.first_end - plate.corner;
  const Vector3 second = plate.second_end - plate.corner;
  if (!(first.cross(second).norm() > 1e-6 * first.norm() * second.norm()))
    fail("Plate", "must have two edges that have a length and are not parallel");
  return generate({plate.elements, false, plate.shape, [&](double a, double b) -> Vector3 {
                     return plate.corner + a * first + b * second;
                   }});
}

Mesh generate_cylinder(const Cylinder &cylinder) {
  const Vector3 axis = cylinder.end - cylinder.start;
  const double range = std::abs(cylinder.angles[1] - cylinder.angles[0]);
  if (!(axis.norm() > 0))
    fail("Cylinder", "must have an axis with two different ends");
  if (!(cylinder.radius > 0))
    fail("Radius", "must be greater than 0");
  if (!(range > 0 && range <= full_turn * (1 + 1e-12)))
    fail("Angles", "must be different and at most 360 deg apart");
  const Vector3 z = axis.normalized();
  const Vector3 wanted = cylinder.zero.value_or(
      z.cross(Vector3::UnitX()).norm() > 0.1 ? Vector3::UnitX() : Vector3::UnitY());
  const Vector3 x = wanted - wanted.dot(z) * z;
  if (!(x.norm() > 1e-6 * wanted.norm()))
    fail("Orientation", "must not be zero or parallel to the axis of the cylinder");
  const Vector3 zero = cylinder.radius * x.normalized();
  const bool closed = range >= full_turn * (1 - 1e-12);
  return generate({cylinder.elements, closed, cylinder.shape, [&](double a, double b) -> Vector3 {
                     const double angle = (1 - a) * cylinder.angles[0] + a * cylinder.angles[1];
                     return cylinder.start + b * axis + Eigen::AngleAxisd(angle, z) * zero;
                   }});
}

} // namespace vibroimpact::structure
