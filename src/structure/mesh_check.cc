#include "structure/mesh_check.h"

#include "structure/hexahedron.h"
#include "structure/node_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

namespace vibroimpact::structure {

namespace {

// Sine of the sharpest and the bluntest corner that still gives useful strains: 3 degrees.
constexpr double least_sine = 0.05;
// Determinant of the Jacobian over the product of the lengths of its columns: rounding.
constexpr double least_solid_jacobian = 1e-9;
// Cosine between the normals at opposite corners of a quadrilateral: 60 degrees.
constexpr double least_alignment = 0.5;

[[noreturn]] void fail(const std::string &problem) {
  throw DefinitionError("Geometry", "", "Mesh", problem);
}

void check_parts(const NodeSets &parts) {
  if (parts.count() > 1)
    fail("must be one connected body, but has " + std::to_string(parts.count()) +
         " parts that share no node (coincident nodes must be merged)");
}

void check_length(const Mesh &mesh, int line) {
  if (mesh.line_length(line) <= 1e-12 * mesh.extent())
    fail("must have cells of positive length, but the one at " +
         coordinates(mesh.nodes[mesh.lines[line][0]]) + " has none");
}

Vector3 unit_corner_normal(const Mesh &mesh, const Cell &surface, int corner) {
  const auto nodes = surface.nodes();
  const Vector3 &here = mesh.nodes[nodes[corner]];
  const Vector3 next = mesh.nodes[nodes[(corner + 1) % surface.size]] - here;
  const Vector3 last = mesh.nodes[nodes[(corner + surface.size - 1) % surface.size]] - here;
  return next.normalized().cross(last.normalized()); // length: sine of the angle
}

std::string place(const Mesh &mesh, const Cell &surface) {
  Vector3 centre = Vector3::Zero();
  for (const int node : surface.nodes())
    centre += mesh.nodes[node] / surface.size;
  return "the one around " + coordinates(centre);
}

void check_corners(const Mesh &mesh, const Cell &surface) {
  Vector3 mean = Vector3::Zero();
  for (int corner = 0; corner < surface.size; ++corner)
    mean += unit_corner_normal(mesh, surface, corner);
  for (int corner = 0; corner < surface.size; ++corner) {
    const Vector3 normal = unit_corner_normal(mesh, surface, corner);
    const std::string at = coordinates(mesh.nodes[surface.corners[corner]]);
    if (normal.dot(mean) < -least_sine || (mean.norm() < least_sine && surface.size == 4))
      fail("must have convex cells, but " + place(mesh, surface) +
           " is inverted or folded at the corner " + at);
    if (!(normal.norm() >= least_sine))
      fail("must have no cell with an angle below 3 or above 177 degrees, but " +
           place(mesh, surface) + " has one at " + at);
  }
}

void check_surface(const Mesh &mesh, const Cell &surface) {
  const auto nodes = surface.nodes();
  if (std::set<int>(nodes.begin(), nodes.end()).size() < nodes.size())
    fail("must have cells with different corners, but " + place(mesh, surface) + " has one twice");
  check_corners(mesh, surface);
  for (int corner = 0; surface.size == 4 && corner < 2; ++corner) {
    const Vector3 normal = unit_corner_normal(mesh, surface, corner);
    const Vector3 opposite = unit_corner_normal(mesh, surface, corner + 2);
    if (normal.dot(opposite) < least_alignment * normal.norm() * opposite.norm())
      fail("must have cells that are nearly flat, but " + place(mesh, surface) +
           " is warped by more than 60 degrees");
  }
}

/// `what`: of that dimension, or lines with these positions, use nodes.
void check_orphans(const Mesh &mesh, int dimension, const std::vector<int> &beams,
                   const std::string &what) {
  std::vector<bool> used(mesh.nodes.size(), false);
  for (const Cell &cell : mesh.cells)
    for (const int node : cell.nodes())
      used[node] = used[node] || cell_type(cell.shape).dimension == dimension;
  for (const int beam : beams)
    for (const int node : mesh.lines[beam])
      used[node] = true;
  const auto orphan = std::find(used.begin(), used.end(), false);
  if (orphan != used.end())
    fail("must have no node without a cell, but " +
         std::to_string(std::count(used.begin(), used.end(), false)) + " belong to no " + what +
         ", the first at " + coordinates(mesh.nodes[orphan - used.begin()]));
}

} // namespace

void check_line_mesh(const Mesh &mesh) {
  if (!mesh.cells.empty())
    fail("must hold lines only, but has " + std::to_string(mesh.cells.size()) +
         " surfaces or volumes (they belong to a body of type shell or solid)");
  if (mesh.lines.empty())
    fail("must hold line cells, but has none");
  NodeSets parts(mesh.nodes.size());
  for (std::size_t line = 0; line < mesh.lines.size(); ++line) {
    check_length(mesh, static_cast<int>(line));
    parts.join(mesh.lines[line][0], mesh.lines[line][1]);
  }
  check_parts(parts);
}

void check_surface_mesh(const Mesh &mesh, const std::vector<int> &beams) {
  if (mesh.cells.empty())
    fail("must hold triangles or quadrilaterals, but has none (gmsh -2 makes them; they belong to "
         "a physical group when there are any groups)");
  for (const Cell &surface : mesh.cells) {
    if (cell_type(surface.shape).dimension != 2)
      fail("must hold triangles and quadrilaterals only, but has volumes (they belong to a body of "
           "type solid; gmsh -2 makes surfaces)");
    check_surface(mesh, surface);
  }
  check_orphans(mesh, 2, beams, "surface or beam");
  NodeSets parts(mesh.nodes.size());
  for (const Cell &surface : mesh.cells)
    for (int corner = 1; corner < surface.size; ++corner)
      parts.join(surface.corners[0], surface.corners[corner]);
  for (const int beam : beams) {
    check_length(mesh, beam);
    parts.join(mesh.lines[beam][0], mesh.lines[beam][1]);
  }
  check_parts(parts);
}

void check_solid_mesh(const Mesh &mesh) {
  NodeSets parts(mesh.nodes.size());
  int number = 0;
  for (const Cell &cell : mesh.cells) {
    if (cell_type(cell.shape).dimension != 3)
      continue;
    ++number;
    std::vector<Vector3> positions;
    for (const int node : cell.nodes()) {
      positions.push_back(mesh.nodes[node]);
      parts.join(cell.corners[0], node);
    }
    if (!(least_jacobian(positions) > least_solid_jacobian))
      fail("must have no solid that is flat, folded or inside out, but number " +
           std::to_string(number) + ", " + place(mesh, cell) +
           ", has a Jacobian that is not positive");
  }
  if (number == 0)
    fail("must hold hexahedra, but has none (they belong to a physical group when there are any "
         "groups)");
  check_orphans(mesh, 3, {}, "solid");
  check_parts(parts);
}

void check_orientation(const Mesh &mesh, const std::vector<int> &surfaces, const std::string &kind,
                       const std::string &name, const std::string &key) {
  std::set<std::array<int, 2>> directed;
  for (const int number : surfaces) {
    const auto nodes = mesh.cells[number].nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!directed.insert({nodes[i], nodes[(i + 1) % nodes.size()]}).second)
        throw DefinitionError(kind, name, key,
                              "must act on surfaces whose normals point to the same side, but two "
                              "neighbours at " +
                                  coordinates(mesh.nodes[nodes[i]]) +
                                  " have opposite ones (or more than two meet there)");
  }
}

} // namespace vibroimpact::structure
