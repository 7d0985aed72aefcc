// Periodic motions: found from a state nearby, with the smallest map of which they are fixed
// points, and the section phase away from their contact changes.
#pragma once

#include "periodic/shooting.h"

namespace vibroimpact::periodic {

struct Orbit {
  Section section;
  FixedPoint point;    ///< of the map of that section
  long iterations = 0; ///< of Newton's method until it was found

  /// Periods after which the motion repeats itself.
  long multiple() const { return section.multiple(); }
  /// The motion is its own image by the symmetry of the model.
  bool symmetric() const { return section.with_symmetry(); }
  /// Of the whole motion: those of the map, or their squares where that is half the motion.
  Eigen::VectorXcd multipliers(const StroboscopicMap &map) const;
};

/// Smaller than 1 in absolute value, all of them.
bool is_stable(const Eigen::VectorXcd &multipliers);

/// The periodic motion of at most `multiple` periods near a state at phase 0. The symmetry of the
/// map is used where the motion has it, and a smaller multiple where it repeats itself earlier.
/// NumericalError.
Orbit find_orbit(const StroboscopicMap &map, long multiple, const Vector &state);

/// The state of the motion at phase 0.
Vector state_at_zero_phase(const StroboscopicMap &map, const Orbit &orbit);

/// Where a motion should be cut: the phase in the middle of its calmest stay, as time after the
/// present section [periods]; 0 when an event is no nearer than `least` [periods], or no phase is
/// much farther from one.
double section_shift(const EventPattern &pattern, double period, double least);

} // namespace vibroimpact::periodic
