// Bodies without a mesh: masses on springs and dashpots, with a coordinate for each axis along
// which or about which they move.
//
// Rotations are small, or about one axis, or those of a sphere at its surface: a point with the arm
// r from the centre moves by u + theta x r, with r fixed in space. So the point of a wheel or a
// sphere at which it touches has the velocity v + omega x r however far it rolls, and a gear's
// point of the line of action moves by its base radius times the angle however far it turns.
#pragma once

#include "reduction/body_definition.h"
#include "reduction/reduced_body.h"

namespace vibroimpact::reduction {

/// Throws structure::DefinitionError for a body without masses, for a mass or an inertia that is
/// not positive where it moves, and for a point without a mass.
ReducedBody lumped_body(const BodyDefinition &definition);

} // namespace vibroimpact::reduction
