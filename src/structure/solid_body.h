// The elements of a body of solids on the hexahedra of its mesh.
#pragma once

#include "structure/body_model.h"

namespace vibroimpact::structure {

/// From the file, or the block. Throws DefinitionError.
Mesh solid_mesh(const SolidDefinition &definition);

/// One element for each solid, in the order of the mesh. Throws DefinitionError when a solid has no
/// part or two, when a mesh does not pass its checks, or when a material is out of range.
void add_solid_elements(BodyModel &model, const SolidDefinition &definition);

/// Adds nodal forces to the load: the pressure pushes against outer faces. Throws DefinitionError.
void add_solid_pressure(BodyModel &model, const Load &load);

/// Leaves out surfaces and lines, which carry no elements and only say where the groups are.
void keep_solids(Mesh &mesh);

} // namespace vibroimpact::structure
