// What a body of solids is made of, as plain data in SI units: a mesh of hexahedra from a file or a
// block, materials of its parts, supports, points and loads.
#pragma once

#include "structure/shell_definition.h"

namespace vibroimpact::structure {

/// A parallelepiped: three edges from a corner, `elements[i]` along the edge i.
struct Block {
  Vector3 corner = Vector3::Zero(); ///< [m]
  std::array<Vector3, 3> ends{};    ///< where the edges from the corner end [m]
  std::array<int, 3> elements{10, 1, 1};
};

struct SolidDefinition {
  std::string mesh_content; ///< of a Gmsh mesh file; empty: the block
  Block block;
  std::vector<MeshPart> parts;       ///< one without a name has the material of the body
  std::optional<int> plane_normal{}; ///< axis along which nothing moves
  std::vector<Support> supports;
  std::vector<Point> points;
  std::vector<RigidLink> links{};
  std::vector<Interface> interfaces{};
  std::vector<Load> loads{};
};

} // namespace vibroimpact::structure
