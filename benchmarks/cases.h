// The systems of the comparison.
#pragma once

#include "measurement.h"

namespace vibroimpact::benchmarks {

/// A forced mass against a linear stop, one impact per period.
Case forced_mass_on_linear_stop();
/// The same mass against a Hertz stop with Hunt-Crossley damping.
Case forced_mass_on_hertz_stop();
/// Two cantilevers with 10 modes each, released towards each other: Hertz contact with
/// Hunt-Crossley damping between their heads.
Case released_beams();

} // namespace vibroimpact::benchmarks
