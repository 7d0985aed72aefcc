// What a motion counts of itself.
#pragma once

#include "motion/episode/step_reason.h"

#include <numeric>

namespace vibroimpact::motion {

/// How well a motion was integrated since start(), the energy since the last stretch without
/// integrals.
struct Accuracy {
  long steps = 0;
  long rejected_steps = 0;
  long events = 0;
  double energy_residual = 0; ///< |unaccounted energy| / (initial + |input|); NaN: not kept
  /// What it stays below where the balance closes: 1e-10 where every step was exact, else a
  /// thousand times the relative tolerance when that is more.
  double energy_threshold = 0;
  double event_residual = 0; ///< largest uncertainty of an event's instant [s]
  /// Touches so shallow that rounding decides whether they were contacts; not counted as events.
  long undecided_events = 0;
  long chatters = 0; ///< infinite sequences of impacts that were completed at once
  /// Impacts of several contacts with friction whose restitution was reduced, so that the energy
  /// did not grow.
  long reduced_restitutions = 0;
  long contact_episodes = 0;  ///< nonlinear ones that were solved as a whole
  long moment_steps = 0;      ///< over contact changes of any number
  StepReasons step_reasons{}; ///< nonlinear ones that were integrated in steps

  long stepped_contacts() const {
    return std::accumulate(step_reasons.begin(), step_reasons.end(), 0L);
  }

  /// False when the energy balance does not close.
  bool balanced() const { return !(energy_residual > energy_threshold); }
};

} // namespace vibroimpact::motion
