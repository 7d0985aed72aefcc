// Which part of a body, with its material, each cell of a mesh belongs to, and the element on it.
#pragma once

#include "structure/element.h"
#include "structure/mesh.h"
#include "structure/shell_definition.h"

namespace vibroimpact::structure {

/// Position of its part for each cell of this dimension, -1 for the others. `kind` is that of the
/// parts' sections. Throws DefinitionError for a cell in no part or in two.
std::vector<int> parts_of_cells(const Mesh &mesh, const std::vector<MeshPart> &parts, int dimension,
                                const std::string &kind);

/// `normals`: of a surface at its corners. Throws DefinitionError for a thickness or material out
/// of range.
std::shared_ptr<const Element> element_on(const Mesh &mesh, const Cell &cell,
                                          std::span<const Vector3> normals, const MeshPart &part);

} // namespace vibroimpact::structure
