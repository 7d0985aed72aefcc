// The systems of the comparison, each from its steady motion on.
#pragma once

#include "measurement.h"

namespace vibroimpact::benchmarks {

/// A mass between two bumpers that creep back by themselves, on a shaken base: two contacts per
/// period.
Case bumpers();
/// Two masses on a shaken table that meet across a gap.
Case bilinear_masses();
/// A vibro-impact damper on a driven floor, Hertz contact of steel.
Case absorber();
/// Two cantilevers with ten modes each, one driven at its tip, steel heads.
Case beam_pair();
/// One such cantilever with twenty modes, driven at its tip, against a linear spring.
Case beam_on_stop();

} // namespace vibroimpact::benchmarks
