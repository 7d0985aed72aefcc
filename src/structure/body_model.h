// A body before it becomes matrices: mesh, elements, supports, lumped masses and loads with their
// nodes found and everything checked.
#pragma once

#include "structure/element.h"
#include "structure/mesh.h"
#include "structure/solid_definition.h"
#include "structure/triangle_locking.h"

#include <functional>
#include <memory>

namespace vibroimpact::structure {

/// A named node, by itself or as one of an interface.
struct NamedNode {
  std::string name;
  int node = 0;
  std::string interface {}; ///< empty for a point by itself
};

/// Inertia of what is fixed to a node, rows and columns u, v, w, rx, ry, rz [kg, kg m, kg m^2].
using LumpedMass = Eigen::Matrix<double, 6, 6>;

struct GivenMatrices;

/// What turning at a speed Omega adds to an element or a lumped mass, see beam_spin.h. Rows are
/// u, v, w, rx, ry, rz of its nodes in global axes.
struct SpinPart {
  std::vector<int> nodes;
  NodalMatrix gyroscopic, turning, crosswise;
  NodalMatrix stiffness{};   ///< of an element alone, by which its internal damping goes; or empty
  NodalMatrix circulatory{}; ///< likewise, of the fixed frame
  NodalMatrix centrifugal{}; ///< of the rotating frame; empty in the fixed one
  NodalVector load{};        ///< likewise
  /// Geometric stiffness from the displacement of the nodes under the load of all parts; none
  /// where there is no line.
  std::function<NodalMatrix(const NodalVector &)> stiffening{};
};

struct BodyModel {
  Mesh mesh;
  Elements elements;                         ///< of any kind; they share the mesh's nodes
  std::vector<std::array<bool, 6>> fixed;    ///< per node and component
  std::vector<std::array<double, 6>> spring; ///< per node and component [N/m], [N m/rad]
  std::map<int, LumpedMass> lumped_masses;   ///< by node
  std::vector<NamedNode> points;
  std::vector<std::vector<int>> rigid; ///< nodes that move as one rigid body, ascending, each once
  bool loaded = false;
  std::vector<std::array<double, 6>> load;      ///< per node and component [N], [N m]
  Vector3 acceleration = Vector3::Zero();       ///< of gravity [m/s^2]
  std::optional<TriangleLocking> locking;       ///< of a shell with triangles that are too large
  double wave_speed = 0;                        ///< largest sqrt(E / rho) of its materials [m/s]
  bool prestressed = false;                     ///< axial forces act before any motion
  std::shared_ptr<const GivenMatrices> given{}; ///< in the place of elements
  std::vector<SpinPart> spinning{};             ///< about the axis of the body

  /// Mass of the elements, without lumped masses [kg].
  double distributed_mass() const;
  double total_mass() const;
  void add_material(const Material &material);
};

/// The inertia of the mass of a point, at r from its node and rigidly fixed to it.
LumpedMass lumped_mass(const Point &point);

/// What bodies of all types with a mesh have.
struct BodyParts {
  std::optional<int> plane_normal{}; ///< axis along which nothing moves
  const std::vector<Support> &supports;
  const std::vector<Point> &points;
  const std::vector<Interface> &interfaces;
  const std::vector<Load> &loads;
};
/// Finds their nodes in the mesh, which is there already. Throws DefinitionError.
void add_parts(const BodyParts &parts, BodyModel &model);

/// All throw DefinitionError when the definition cannot be built.
BodyModel build_frame(const BeamDefinition &definition);
BodyModel build_shell(const ShellDefinition &definition);
BodyModel build_solid(const SolidDefinition &definition);

} // namespace vibroimpact::structure
