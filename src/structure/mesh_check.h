// Is a mesh fit for elements? Said in words that lead to the place in the mesh.
#pragma once

#include "structure/mesh.h"

namespace vibroimpact::structure {

/// For a body of lines alone. Throws DefinitionError when the mesh has no lines, lines without
/// length, or separate parts.
void check_line_mesh(const Mesh &mesh);

/// For a body of surfaces, and of those lines that carry beams (positions in mesh.lines). Throws
/// DefinitionError when there are no surfaces, cells that are degenerate, inverted or too
/// distorted, separate parts, or nodes that neither a surface nor a beam uses.
void check_surface_mesh(const Mesh &mesh, const std::vector<int> &beams);

/// For a body of solids, whose surfaces and lines only name places. Throws DefinitionError when
/// there are no solids, degenerate ones, separate parts, or nodes that no solid uses.
void check_solid_mesh(const Mesh &mesh);

/// Throws DefinitionError of the section `kind` `name`, key `key`, when two neighbours among these
/// surfaces have opposite normals, so that a pressure would change its side.
void check_orientation(const Mesh &mesh, const std::vector<int> &surfaces, const std::string &kind,
                       const std::string &name, const std::string &key);

} // namespace vibroimpact::structure
