// Where a contact tends to in the present modes.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// Acceleration of its gap (direction 0) or slip rate (1) [m/s^2].
double present_acceleration(const Equations &equations, std::size_t contact, double time,
                            const Vector &state, int direction = 0);

/// The same, or what takes its place where that is zero to rounding: the acceleration a little
/// later of a motion from here, by a step of the classical Runge-Kutta method, whose error of order
/// five leaves the signs of the next three derivatives. Zero: it is zero to rounding then too.
double leading_acceleration(const Equations &equations, std::size_t contact, double time,
                            const Vector &state, int direction = 0);

} // namespace vibroimpact::motion
