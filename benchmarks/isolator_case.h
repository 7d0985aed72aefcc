// An isolator between two damped elastic stops, y'' + 2 zeta0 y' + y + stops = f sin(lambda t): the
// equations of both sides of a comparison.
#pragma once

#include "analyses/run/system.h"
#include "equations_by_hand.h"

namespace vibroimpact::benchmarks {

/// f = 0.52, zeta0 = 0.01, zeta1 = 0.2.
Isolator isolator_by_hand(double lambda, double mu = 2);
analyses::System isolator_system(double lambda, double mu = 2);

} // namespace vibroimpact::benchmarks
