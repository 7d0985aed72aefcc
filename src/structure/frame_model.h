// A beam body before it becomes matrices: mesh, elements, supports and lumped masses with their
// nodes found and everything checked.
#pragma once

#include "structure/frame_element.h"
#include "structure/line_mesh.h"

namespace vibroimpact::structure {

/// A named node.
struct NamedNode {
  std::string name;
  int node = 0;
};

struct FrameModel {
  LineMesh mesh;
  BeamProperties properties;
  std::vector<ElementFrame> frames;               ///< per cell
  std::vector<std::array<bool, 6>> fixed;         ///< per node and component
  std::vector<std::array<double, 6>> spring;      ///< per node and component [N/m], [N m/rad]
  std::vector<std::array<double, 6>> lumped_mass; ///< per node and component [kg], [kg m^2]
  std::vector<NamedNode> points;

  /// Mass of the beam itself, without lumped masses [kg].
  double distributed_mass() const;
  double total_mass() const;
};

/// Throws DefinitionError when the definition cannot be built.
FrameModel build_frame(const BeamDefinition &definition);

} // namespace vibroimpact::structure
