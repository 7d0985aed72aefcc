// The time integrator `flight` as a PETSc TS type: one TSStep is one exact step of a linear phase.
//
// The type knows nothing of the equations. Whoever sets it hands over the phase that propagates the
// state; without one TSStep ends with an error.
#pragma once

#include "common/linear_algebra.h"

// PETSc's object under its own name; its headers stay in flight.cc.
struct _p_TS; // NOLINT(bugprone-reserved-identifier)

namespace vibroimpact::integration {

constexpr const char *flight_type = "flight";

class FlightPropagator {
public:
  virtual ~FlightPropagator() = default;
  /// x at `tau` [s] after the start of the step from x there.
  virtual void propagate(double tau, ConstVectorView from, VectorView to) = 0;
  /// Longest step from the start of the present step [s].
  virtual double natural_step() = 0;
};

/// Makes the type known to PETSc; once is enough, more do no harm.
void register_flight();

/// The propagator of a TS of this type; must outlive its use.
void set_flight_propagator(_p_TS *ts, FlightPropagator *propagator);

} // namespace vibroimpact::integration
