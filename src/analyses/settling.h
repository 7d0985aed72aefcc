// Lets a periodically forced motion settle, and says what it has settled to.
#pragma once

#include "motion/trajectory.h"
#include "parameters/values.h"

#include <functional>

namespace vibroimpact::analyses {

struct SettlingRule {
  long minimum = 0;          ///< [periods]
  long maximum = 0;          ///< [periods]
  double tolerance = 0;      ///< see Steadiness
  long longest_multiple = 1; ///< [periods]
  bool extrapolates = false; ///< goes to where the periods lead as soon as that is clear
  /// Ends, not steady, after so many periods that bring the motion no nearer to a repetition; 0:
  /// never [periods]
  long without_approach = 0;
};

void declare_settling(parameters::Section &section);
SettlingRule read_settling(const parameters::Values &section);

/// A motion at the end of its settling. The range is that of its states at the ends of periods:
/// over one repetition when it is steady, else over as many of the last periods as are looked at.
/// It does not depend on which of its periods a motion of several periods ends with.
struct SettledMotion {
  motion::MotionState state;
  Vector lowest, highest; ///< physical states
  long cycles = 0;        ///< periods it took
  long multiple = 0;      ///< periods after which it repeats; 0 when it is not steady

  bool steady() const { return multiple > 0; }
};

/// Goes on from where the trajectory stands, at time zero, period by period and without being
/// observed, or straight to the limit of the periods, from which it must go on to be steady by
/// itself. `scale` as for Steadiness. `after_period`, where given, is called with the number of
/// periods behind each of them. NumericalError.
SettledMotion settle(motion::Trajectory &trajectory, double period, const Vector &scale,
                     const SettlingRule &rule,
                     const std::function<void(long periods)> &after_period = {});

/// Largest difference of two ranges over the largest state in either, both times `scale`.
double relative_distance(const SettledMotion &a, const SettledMotion &b, const Vector &scale);

} // namespace vibroimpact::analyses
