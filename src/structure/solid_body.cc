#include "structure/solid_body.h"

#include "structure/block_mesh.h"
#include "structure/cell_parts.h"
#include "structure/gmsh_reader.h"
#include "structure/mesh_check.h"
#include "structure/quadrilateral_geometry.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

bool is_solid(const Cell &cell) { return cell_type(cell.shape).dimension == 3; }

std::vector<Cell> solids_of(const Mesh &mesh) {
  std::vector<Cell> solids;
  std::copy_if(mesh.cells.begin(), mesh.cells.end(), std::back_inserter(solids), is_solid);
  return solids;
}

std::vector<int> sorted_nodes(std::span<const int> nodes) {
  std::vector<int> sorted(nodes.begin(), nodes.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// Outer faces, their corners around the outward normal, by their nodes in ascending order.
std::map<std::vector<int>, std::vector<int>> outer_faces(const Mesh &mesh) {
  std::map<std::vector<int>, std::vector<int>> outer;
  for (const std::vector<int> &face : visible_faces(solids_of(mesh)))
    outer.emplace(sorted_nodes(face), face);
  return outer;
}

/// The outer faces that a load means.
std::vector<std::vector<int>> pressed_faces(const Mesh &mesh, const Load &load) {
  const auto outer = outer_faces(mesh);
  std::vector<std::vector<int>> faces;
  if (load.on == "all") {
    for (const auto &[nodes, face] : outer)
      faces.push_back(face);
    return faces;
  }
  for (const int number :
       find_cells(mesh.cell_groups, load.on, mesh.cells.size(), "Load", load.name)) {
    const auto face = outer.find(sorted_nodes(mesh.cells[number].nodes()));
    if (face == outer.end())
      throw DefinitionError("Load", load.name, "On",
                            "must be a group of outer faces of the solids, but the one at " +
                                coordinates(mesh.nodes[mesh.cells[number].corners[0]]) +
                                " is none");
    faces.push_back(face->second);
  }
  return faces;
}

} // namespace

Mesh solid_mesh(const SolidDefinition &definition) {
  return definition.mesh_content.empty() ? generate_block(definition.block)
                                         : parse_gmsh(definition.mesh_content);
}

void add_solid_elements(BodyModel &model, const SolidDefinition &definition) {
  check_solid_mesh(model.mesh);
  const std::vector<int> parts = parts_of_cells(model.mesh, definition.parts, 3, "Solid");
  for (std::size_t cell = 0; cell < parts.size(); ++cell)
    if (parts[cell] >= 0)
      model.elements.push_back(
          element_on(model.mesh, model.mesh.cells[cell], {}, definition.parts[parts[cell]]));
}

void add_solid_pressure(BodyModel &model, const Load &load) {
  for (const std::vector<int> &face : pressed_faces(model.mesh, load)) {
    NodeVectors corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
      corners[i] = model.mesh.nodes[face[i]];
    const NodeVectors areas = corner_areas(corners);
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        model.load[face[i]][axis] -= load.pressure * areas[i][axis];
  }
}

void keep_solids(Mesh &mesh) {
  mesh.cells = solids_of(mesh);
  mesh.lines.clear();
  mesh.cell_groups.clear();
  mesh.line_groups.clear();
}

} // namespace vibroimpact::structure
