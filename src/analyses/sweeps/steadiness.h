// Decides from states taken once per forcing period whether a motion has become periodic.
#pragma once

#include "analyses/run/last_states.h"
#include "motion/path/trajectory.h"

#include <limits>

namespace vibroimpact::analyses {

class Steadiness {
public:
  /// `scale`: what makes the physical states comparable (1/m, s/m, ...); multiples up to `longest`.
  Steadiness(Vector scale, long longest, double tolerance);

  /// Forgets all states.
  void clear();
  /// Takes the state at the end of the next period.
  void add(const Eigen::Ref<const Vector> &physical);
  /// Is the estimated distance to the periodic motion below the tolerance?
  bool steady() const { return multiple_ > 0; }
  /// The least number of periods after which the motion that it has come so near to repeats; 0 when
  /// it is not steady.
  long multiple() const { return multiple_; }
  /// Periods since the state has last come nearer to one of those up to the longest multiple before
  /// it than ever since the start.
  long without_approach() const { return without_approach_; }

private:
  long shortest(Index k, double distance) const;
  void note_approach();

  Vector scale_;
  Index longest_;
  double tolerance_;
  LastStates states_; ///< scaled
  long multiple_ = 0;
  double nearest_ = std::numeric_limits<double>::infinity();
  long without_approach_ = 0;
};

/// Scales for the states of a model: displacements by the largest displacement of a point per unit
/// coordinate, velocities the same divided by the natural (or, for rigid modes, the forcing)
/// angular frequency. Speeds that a contact remembers are divided by the forcing frequency.
Vector state_scale(const motion::Equations &equations, double forcing_frequency);

/// The same for deviations, which have no entry of no importance: where a coordinate moves no
/// point, its own unit is as good as any.
Vector deviation_scale(const motion::Equations &equations, double forcing_frequency);

} // namespace vibroimpact::analyses
