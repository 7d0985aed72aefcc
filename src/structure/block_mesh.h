// Meshes of hexahedra made by formula: blocks.
#pragma once

#include "structure/mesh.h"
#include "structure/solid_definition.h"

namespace vibroimpact::structure {

/// Groups of nodes and of faces: "left" and "right" (begin and end of the first edge), "bottom" and
/// "top" (of the second), "back" and "front" (of the third). The nodes of an edge are in a group of
/// the names of the two faces in that order, "left bottom". The hexahedra come first, then the
/// faces, their normals outward. Throws DefinitionError for edges that span no volume, or without
/// elements.
Mesh generate_block(const Block &block);

} // namespace vibroimpact::structure
