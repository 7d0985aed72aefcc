// Lets a periodically forced motion settle, and says what it has settled to.
#pragma once

#include "motion/variation/linearised_motion.h"
#include "parameters/values.h"

#include <functional>
#include <optional>

namespace vibroimpact::analyses {

struct SettlingRule {
  long minimum = 0;          ///< [periods]
  long maximum = 0;          ///< [periods]
  double tolerance = 0;      ///< see Steadiness
  long longest_multiple = 1; ///< [periods]
  /// Periods after which the periodic motion that it approaches is looked for by Newton's method, 2
  /// at least; none: it settles by itself.
  std::optional<long> newton_after{};
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

/// Lets motions of one trajectory settle, one after the other.
class Settler {
public:
  /// Keeps a reference.
  explicit Settler(motion::Trajectory &trajectory) : trajectory_(trajectory) {}

  /// Goes on from where the trajectory stands, at time zero, period by period and without being
  /// observed, or by Newton's method straight to the periodic motion. Where there is no variation
  /// for that, as for rotors and excitations that do not repeat themselves, or the motion is not
  /// seen to approach what is found, it goes on by itself. `scale` as for Steadiness.
  /// `after_period`, where given, is called with the number of periods behind each of them.
  /// NumericalError.
  SettledMotion operator()(double period, const Vector &scale, const SettlingRule &rule,
                           const std::function<void(long periods)> &after_period = {});

private:
  bool repeats(double period) const;
  motion::Lineariser &lineariser(const Vector &scale);

  motion::Trajectory &trajectory_;
  Vector scale_;                                 ///< of deviations
  std::optional<motion::Lineariser> lineariser_; ///< once asked for
};

/// Largest difference of two ranges over the largest state in either, both times `scale`.
double relative_distance(const SettledMotion &a, const SettledMotion &b, const Vector &scale);

} // namespace vibroimpact::analyses
