// Rotors of the parameter file: bodies of type rotor.
#pragma once

#include "model/model.h"
#include "parameters/values.h"

namespace vibroimpact::model {

/// Puts every body of type rotor onto the point that carries it; sources must be complete.
/// InputError for an unknown point, a point of a rotor, and directions that are not perpendicular.
void add_rotors(const parameters::Values &root, Model &model);

} // namespace vibroimpact::model
