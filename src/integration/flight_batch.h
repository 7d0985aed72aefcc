// Several motions at once in one thread, so that their flights share the vector lanes.
//
// Each motion is worked at by a fiber. Where it would fly, its kernel goes into the lanes and the
// fiber waits; when all wait, the lanes fly. What a motion does depends on none of the others.
#pragma once

#include "integration/flight_lanes.h"

#include <functional>

namespace vibroimpact::integration {

/// Thrown into the works that still wait when one of them has ended with an exception.
struct BatchBrokenOff {};

/// Runs `work` in `count` fibers at once, until every one of them has returned; just once without
/// fibers when `count` is 1, inside another batch, or where fibers cannot be used. When one throws,
/// the others are ended where they fly next, and its exception is thrown on; Interrupted when the
/// run is to stop while all of them fly.
void run_batch(std::size_t count, const std::function<void()> &work);

/// kernel.fly(limit), in the lanes when the caller runs in a batch.
FlightKernel::End fly_in_batch(FlightKernel &kernel, double limit);

} // namespace vibroimpact::integration
