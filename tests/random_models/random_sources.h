// Excitations of every type and history.
#pragma once

#include "random_models/random_bodies.h"

namespace vibroimpact::testing {

/// `frequency` [rad/s] is that of the first one; pulses and sweeps fit into `duration` [s].
std::string random_sources(Draw &draw, const RandomBodies &bodies, double frequency,
                           double duration);

} // namespace vibroimpact::testing
