// Solid bodies that several tests use.
#pragma once

#include "structure/body_model.h"

namespace vibroimpact::examples {

using structure::SolidDefinition;

/// A block along the axes from the origin.
inline structure::Block block(const Vector3 &size, const std::array<int, 3> &elements) {
  return {.ends = {Vector3(size[0], 0, 0), Vector3(0, size[1], 0), Vector3(0, 0, size[2])},
          .elements = elements};
}

inline SolidDefinition solid_block(const Vector3 &size, const std::array<int, 3> &elements,
                                   const structure::Material &material) {
  SolidDefinition solid;
  solid.block = block(size, elements);
  solid.parts.push_back({.name = "", .material = material});
  return solid;
}

/// Holds these displacements at a group of nodes.
inline void hold(SolidDefinition &solid, const std::string &group,
                 const std::array<bool, 6> &components) {
  solid.supports.push_back({.name = group, .at = {group, {}}, .fixed = components});
}

} // namespace vibroimpact::examples
