// Decides from states taken once per forcing period whether a motion has become periodic.
#pragma once

#include "motion/trajectory.h"

namespace vibroimpact::analyses {

class Steadiness {
public:
  /// `scale`: what makes the physical states comparable (1/m, s/m, ...); multiples up to `longest`.
  Steadiness(Vector scale, long longest, double tolerance);

  /// Takes the state at the end of the next period.
  void add(const Vector &physical);
  /// Is the estimated distance to the periodic motion below the tolerance?
  bool steady() const { return multiple_ > 0; }
  /// The least number of periods after which the motion that it has come so near to repeats; 0 when
  /// it is not steady.
  long multiple() const { return multiple_; }

private:
  long shortest(Index k, double distance) const;
  /// The state of so many periods ago.
  auto state(Index periods) const;
  double change(Index newer, Index older) const;

  Vector scale_;
  Index longest_;
  double tolerance_;
  Matrix states_; ///< scaled, the newest ones in turn, one after the other
  Index seen_ = 0;
  long multiple_ = 0;
};

/// Scales for the states of a model: displacements by the largest displacement of a point per unit
/// coordinate, velocities the same divided by the natural (or, for rigid modes, the forcing)
/// angular frequency.
Vector state_scale(const motion::Equations &equations, double forcing_frequency);

} // namespace vibroimpact::analyses
