// Shell elements on the surfaces of a mesh, for tests of the elements by themselves.
#pragma once

#include "structure/quadrilateral_shell.h"
#include "structure/surface_normals.h"
#include "structure/triangle_shell.h"

namespace vibroimpact::examples {

inline structure::Elements shell_elements(const structure::Mesh &mesh,
                                          const structure::ShellProperties &properties) {
  structure::Elements elements;
  const std::vector<structure::NodeVectors> normals = structure::surface_normals(mesh);
  for (std::size_t number = 0; number < mesh.cells.size(); ++number) {
    const auto &c = mesh.cells[number].corners;
    const auto &at = mesh.nodes;
    if (mesh.cells[number].size == 3)
      elements.push_back(std::make_shared<structure::TriangleShell>(
          std::array{c[0], c[1], c[2]}, std::array{at[c[0]], at[c[1]], at[c[2]]}, properties));
    else
      elements.push_back(std::make_shared<structure::QuadrilateralShell>(
          std::array{c[0], c[1], c[2], c[3]},
          structure::NodeVectors{at[c[0]], at[c[1]], at[c[2]], at[c[3]]}, normals[number],
          properties));
  }
  return elements;
}

} // namespace vibroimpact::examples
