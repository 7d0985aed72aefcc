#include "structure/cell_parts.h"

namespace vibroimpact::structure {

std::vector<int> parts_of_cells(const Mesh &mesh, const std::vector<MeshPart> &parts, int dimension,
                                const std::string &kind) {
  const std::string cells = dimension == 2 ? "surface" : "solid";
  const auto counts = [&](int cell) {
    return cell_type(mesh.cells[cell].shape).dimension == dimension;
  };
  std::vector<int> part_of(mesh.cells.size(), -1);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const int cell :
         find_cells(mesh.cell_groups, parts[p].on, mesh.cells.size(), kind, parts[p].name)) {
      if (counts(cell) && part_of[cell] >= 0)
        throw DefinitionError(kind, parts[p].name, "On",
                              "must not share " + cells + "s with " + kind + " " +
                                  parts[part_of[cell]].name);
      part_of[cell] = counts(cell) ? static_cast<int>(p) : -1;
    }
  for (std::size_t cell = 0; cell < part_of.size(); ++cell)
    if (part_of[cell] < 0 && counts(static_cast<int>(cell)))
      throw DefinitionError(
          "Geometry", "", "Mesh",
          "must have every " + cells + " in a subsection " + kind + ", but the one at " +
              coordinates(mesh.nodes[mesh.cells[cell].corners[0]]) + " is in none");
  return part_of;
}

std::shared_ptr<const Element> element_on(const Mesh &mesh, const Cell &cell,
                                          std::span<const Vector3> normals, const MeshPart &part) {
  std::vector<Vector3> positions;
  for (const int node : cell.nodes())
    positions.push_back(mesh.nodes[node]);
  return cell_type(cell.shape)
      .make({.nodes = cell.nodes(), .positions = positions, .normals = normals, .part = part});
}

} // namespace vibroimpact::structure
