// What a shell body is made of, as plain data in SI units: a surface mesh from a file or a formula,
// thickness and material of its parts, beams as stiffeners, supports, points and loads.
#pragma once

#include "structure/beam_definition.h"
#include "structure/cell.h"

namespace vibroimpact::structure {

/// A parallelogram, `elements[0]` along the first edge and `elements[1]` along the second.
struct Plate {
  Vector3 corner = Vector3::Zero();     ///< [m]
  Vector3 first_end = Vector3::Zero();  ///< where the first edge from the corner ends [m]
  Vector3 second_end = Vector3::Zero(); ///< where the second edge from the corner ends [m]
  std::array<int, 2> elements{10, 10};
  CellShape shape = CellShape::quadrilateral;
};

/// A circular cylinder or a part of one, `elements[0]` around and `elements[1]` along the axis.
struct Cylinder {
  Vector3 start = Vector3::Zero(); ///< of the axis [m]
  Vector3 end = Vector3::Zero();   ///< [m]
  double radius = 0;               ///< [m]
  std::array<double, 2> angles{};  ///< first and last, about the axis [rad]
  std::optional<Vector3> zero;     ///< direction of angle 0, need not be normal to the axis
  std::array<int, 2> elements{10, 10};
  CellShape shape = CellShape::quadrilateral;
};

/// Surfaces of one thickness and material, or solids of one material.
struct MeshPart {
  std::string name;
  std::string on = "all"; ///< group of cells
  double thickness = 0;   ///< of surfaces [m]
  Material material;
};

/// Beams along the lines of a group.
struct Stiffener {
  std::string name;
  std::string on; ///< group of lines
  SectionShape section;
  Material material;
  std::optional<Vector3> local_y; ///< without it, local z is the normal of the shell at the line
  /// From the nodes to the centre of the section along the local y and z axes [m].
  std::array<double, 2> offset{};
  double axial_force = 0; ///< before any motion, tension positive [N]
};

struct ShellDefinition {
  std::string mesh_content; ///< of a Gmsh mesh file; empty: the plate or the cylinder
  std::optional<Plate> plate;
  std::optional<Cylinder> cylinder;
  std::vector<MeshPart> parts;
  std::vector<Stiffener> stiffeners;
  std::optional<int> plane_normal{}; ///< axis along which nothing moves
  std::vector<Support> supports;
  std::vector<Point> points;
  std::vector<RigidLink> links{};
  std::vector<Interface> interfaces{};
  std::vector<Load> loads{};
};

} // namespace vibroimpact::structure
