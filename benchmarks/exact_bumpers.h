// The bumper oscillator in closed form, for this one system: between contact changes
//
//   q(t) = constant + Re(free exp(p t)) + Re(forced exp(i beta t))
//
// and a bumper that is not touched creeps back exponentially. A zero of a guard is approached from
// below by the smallest zero of its cubic lower bound (value, slope, curvature at hand, and a bound
// of the third derivative from the amplitudes), so that none is passed over. What this takes is the
// limit for anything that works point by point.
#pragma once

#include "equations_by_hand.h"
#include "measurement.h"

namespace vibroimpact::benchmarks {

Side exact_bumpers_side(const Bumpers &system, const Bumpers::State &start, double end);

} // namespace vibroimpact::benchmarks
