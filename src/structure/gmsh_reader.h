// Reads the mesh format of Gmsh, versions 2.2 and 4.1, ASCII and binary, as far as meshes of lines,
// triangles and quadrilaterals need it. Format: Gmsh reference manual, "MSH file format".
#pragma once

#include "structure/mesh.h"

#include <string>

namespace vibroimpact::structure {

/// Nodes that no cell uses are dropped; cells that stand in several physical groups count once.
/// Physical groups of points, lines and surfaces are known by name, or by number when they have no
/// name. Throws DefinitionError for other versions, curved cells, volumes, damaged files.
Mesh parse_gmsh(const std::string &content);

} // namespace vibroimpact::structure
