// The elements of a shell body: shells on the surfaces of its mesh, beams along some of its lines.
#pragma once

#include "structure/body_model.h"

namespace vibroimpact::structure {

/// From the file, or the plate or cylinder. Throws DefinitionError.
Mesh shell_mesh(const ShellDefinition &definition);

/// One element for each surface and for each line of a stiffener; the shells come first, in the
/// order of the mesh. Throws DefinitionError when a surface has no part or two, when a mesh does
/// not pass its checks, or when a dimension is out of range.
void add_shell_elements(BodyModel &model, const ShellDefinition &definition);

/// Adds nodal forces to the load. Throws DefinitionError.
void add_shell_pressure(BodyModel &model, const Load &load);

} // namespace vibroimpact::structure
