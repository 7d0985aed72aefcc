// What steps of one phase after the other cost where many nonlinear contacts last at once, against
// steps over all of their changes (moments/).
//
// Each change of a contact ends a step of all, and stages evaluate every law, so that the former
// cost grows with the square of the contacts, the latter with their number. Both are counted in
// operations, of the steps that this motion has taken, so that results depend on neither the
// machine nor the motions before.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

class StepCosts {
public:
  /// Keeps a reference.
  explicit StepCosts(const Equations &equations) : equations_(equations) {}

  /// A motion begins.
  void begin() { spent_ = by_moments_ = 0; }
  /// A step in the present modes that took so many attempts, and did or did not end at a contact
  /// change.
  void note_step(long attempts, bool changes);
  /// The steps so far have cost more than those over all changes would have.
  bool crowded() const;

private:
  double cost_of_attempt() const;

  const Equations &equations_;
  double spent_ = 0, by_moments_ = 0; ///< nominal [ns]
};

} // namespace vibroimpact::motion
