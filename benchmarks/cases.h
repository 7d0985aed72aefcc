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
/// The same from rest, up to the hundredth contact or so.
Case absorber_from_rest();
/// Two cantilevers with ten modes each, one driven at its tip, steel heads.
Case beam_pair();
/// One such cantilever with twenty modes, driven at its tip, against a linear spring.
Case beam_on_stop();
/// A beam that meets a row of equal stops almost at once.
Case one_stop();
Case two_stops();
Case four_stops();
Case eight_stops();
Case sixteen_stops();
/// A mass with dry friction under a harmonic force, which turns at once or stops at every turn.
Case friction_without_stops();
Case friction_with_stops();
/// A rotor driven around an ellipse within a ring, a linear spring or Hertz's force along the
/// radius, without and with friction: three contacts per period.
Case ring();
Case ring_with_friction();
Case hertz_ring();
Case hertz_ring_with_friction();
/// A mass on a spring that stiffens with the cube of its elongation, without contacts.
Case duffing();
/// An unbalanced rotor with a motor of limited power on an elastic frame, without contacts.
Case motor_on_frame();

} // namespace vibroimpact::benchmarks
