// Reads the ASCII mesh format of Gmsh, versions 2.2 and 4.1, as far as line meshes need it.
// Format: Gmsh reference manual, "MSH file format".
#pragma once

#include "structure/line_mesh.h"

#include <string>

namespace vibroimpact::structure {

/// Nodes that no line uses are dropped; lines that stand in several physical groups count once.
/// Physical groups of points and lines are known by name, or by number when they have no name.
/// Throws DefinitionError for binary files, other versions, curved lines, and cells that are not
/// lines.
LineMesh parse_gmsh(const std::string &content);

} // namespace vibroimpact::structure
