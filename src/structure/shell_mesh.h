// Surface meshes made by formula: plates and cylinders.
#pragma once

#include "structure/mesh.h"
#include "structure/shell_definition.h"

namespace vibroimpact::structure {

/// Groups of nodes: "left" and "right" (begin and end of the first direction), "bottom" and "top"
/// (of the second), "edges" (all four). The edges' lines are groups of lines of the same names. The
/// normal is first edge x second edge.
/// Throws DefinitionError for edges without length or parallel to each other, or without elements.
Mesh generate_plate(const Plate &plate);

/// Groups as for a plate, the first direction being around and the second along the axis; a closed
/// cylinder has no "left" and "right". The normal points outwards when the last angle is above the
/// first.
/// Throws DefinitionError for an axis, radius or range of angles of no or too large an extent.
Mesh generate_cylinder(const Cylinder &cylinder);

} // namespace vibroimpact::structure
