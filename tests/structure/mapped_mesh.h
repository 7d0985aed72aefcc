// A regular mesh bent into any shape, as the text of a Gmsh file.
#pragma once

#include "structure/shell_mesh.h"

#include <functional>
#include <sstream>

namespace vibroimpact::examples {

/// The unit square with `columns` x `rows` cells, each node (a, b) at `position`; the groups left,
/// right, bottom and top as in a generated plate.
inline std::string mapped_mesh(int columns, int rows, structure::CellShape shape,
                               const std::function<Vector3(double, double)> &position) {
  const structure::Mesh mesh = structure::generate_plate({.corner = {0, 0, 0},
                                                          .first_end = {1, 0, 0},
                                                          .second_end = {0, 1, 0},
                                                          .elements = {columns, rows},
                                                          .shape = shape});
  std::ostringstream text;
  text.precision(17);
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 1 \"left\"\n1 2 \"right\"\n"
       << "1 3 \"bottom\"\n1 4 \"top\"\n$EndPhysicalNames\n$Nodes\n"
       << mesh.nodes.size() << "\n";
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    text << node + 1 << " " << position(mesh.nodes[node].x(), mesh.nodes[node].y()).transpose()
         << "\n";
  text << "$EndNodes\n$Elements\n" << mesh.cells.size() + mesh.lines.size() << "\n";
  std::size_t element = 0;
  const std::vector<std::string> edges = {"left", "right", "bottom", "top"};
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    for (const int line : mesh.line_groups.at(edges[edge]))
      text << ++element << " 1 2 " << edge + 1 << " 1 " << mesh.lines[line][0] + 1 << " "
           << mesh.lines[line][1] + 1 << "\n";
  for (const structure::Cell &surface : mesh.cells) {
    text << ++element << (surface.size == 3 ? " 2 2 0 1" : " 3 2 0 1");
    for (const int node : surface.nodes())
      text << " " << node + 1;
    text << "\n";
  }
  text << "$EndElements\n";
  return text.str();
}

} // namespace vibroimpact::examples
