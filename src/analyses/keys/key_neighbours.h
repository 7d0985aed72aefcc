// Systems at neighbouring values of a key, for the derivatives of motions by it
// (motion::KeyTangent).
#pragma once

#include "analyses/keys/swept_parameter.h"
#include "analyses/run/system.h"
#include "motion/variation/key_tangent.h"

#include <vector>

namespace vibroimpact::analyses {

/// Four neighbours of the system at `value` of the key [its unit], a thousandth of the value apart
/// (of the largest of its values where it is zero), on both sides or, where the system cannot be
/// built on one of them (a clearance below zero, a restitution above one), on the other. InputError
/// when it cannot be built on either.
std::vector<motion::KeyNeighbour> key_neighbours(const SweptParameter &key, double value,
                                                 const SystemSource &build);

/// The same for the angular frequency [rad/s] of an excitation that has one. The given quantity
/// keeps its amplitude and, at t = 0, its phase.
std::vector<motion::KeyNeighbour> frequency_neighbours(const System &system, std::size_t source);

} // namespace vibroimpact::analyses
