// A rotor as a reduced body: its rotation about its own centre of mass, one coordinate.
#pragma once

#include "reduction/body_definition.h"
#include "reduction/reduced_body.h"

namespace vibroimpact::reduction {

/// One coordinate, the angle [rad]; its mass is the moment of inertia about the centre of mass, its
/// damping the friction. The point "shaft" shows the angle as a rotation. What couples it to the
/// point that carries it is added with the model.
ReducedBody rotor_body(const BodyDefinition &definition);

} // namespace vibroimpact::reduction
