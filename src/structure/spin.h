// The parts of a body that turn at a given speed: elements along members and lumped masses.
#pragma once

#include "structure/beam_definition.h"
#include "structure/body_model.h"
#include "structure/frame_body.h"

namespace vibroimpact::structure {

/// Fills model.spinning; elements, points and lumped masses are there. Throws DefinitionError for
/// members that are not round or not along the axis, for members and points that are not there, and
/// for masses that are not balanced about the axis.
void add_spin(BodyModel &model, const BeamDefinition &definition, const FrameLines &lines);

} // namespace vibroimpact::structure
