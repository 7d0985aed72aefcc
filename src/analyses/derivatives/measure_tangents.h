// Derivatives by a key of what is recorded of one period of a periodic motion, from the variational
// equations alone: extreme values and impacts.
//
// An extreme value max_t m(x(t), t; p) at the instant t* changes by (envelope theorem)
//
//   d max/dp = dm/dp at the fixed time t*         where m is flat, m' = 0
//            = dm/dp + m' dt*/dp, on its side      where t* is an event, which moves by dt*/dp
//
// Where several impacts count together, the mean has the mean of their derivatives and the largest
// one its own.
#pragma once

#include "analyses/derivatives/orbit_derivatives.h"

#include <map>

namespace vibroimpact::analyses {

/// By the names of the fields, per unit of the key. What has no closed form is left out: all where
/// the key moves breaks of the excitation, forces that hold a gap in phases that are not linear,
/// and what other recorders give. `by_key`: derivative of the state at the section, at fixed phase.
std::map<std::string, double> measure_tangents(const RecordedOrbit &motion,
                                               periodic::ForcedKey &key,
                                               const std::vector<motion::KeyNeighbour> &neighbours,
                                               const Vector &by_key);

} // namespace vibroimpact::analyses
