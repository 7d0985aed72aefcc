// The nodes of an interface: those of a group, or the ones of it that are nearest to given places.
#pragma once

#include "structure/mesh.h"

namespace vibroimpact::structure {

/// In the order of the positions, or else of the coordinates, x first (so that the numbering of the
/// mesh does not count). Throws DefinitionError for an unknown or empty group, and when two
/// positions mean the same node.
std::vector<int> interface_nodes(const Mesh &mesh, const Interface &interface);

} // namespace vibroimpact::structure
