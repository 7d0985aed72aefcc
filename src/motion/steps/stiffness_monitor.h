// Notices a phase in which stability, not accuracy, limits the steps of an explicit method.
//
// With the eigenvalues l of the Jacobian, an explicit step h is stable while h |l| stays within a
// bound, about 6 for real l and the Runge-Kutta method of order 8 (Hairer & Wanner, Solving
// Ordinary Differential Equations II, IV.2). Where accuracy asks for less, h |l| is well below it.
// A contact that is damped far beyond its critical damping, as by a dissipation that belongs to a
// much slower impact, makes such steps of microseconds for a body that hardly moves. An implicit
// method has no such bound; its steps cost several times as much, so that they must be longer by
// more than that.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

class StiffnessMonitor {
public:
  /// A phase begins.
  void begin() { *this = {}; }

  /// An explicit step of this length [s] ended at (time, x). True: an implicit method is due.
  bool explicit_step(const Equations &equations, double time, const Vector &x, double length);
  /// An implicit one. True: it does not pay here.
  bool implicit_step(const Equations &equations, double time, const Vector &x, double length);
  /// The implicit method has failed.
  void give_up() { wait(16 * pause_); }

private:
  bool due(double length);
  // Each time twice as long, so that trials in vain cost a share that vanishes.
  void wait(long looks) {
    wait_ = looks;
    pause_ = 2 * looks;
  }

  long steps_ = 0;
  double sum_ = 0; ///< of the lengths since the last look [s]
  int stiff_ = 0;  ///< looks in a row that found stability at its bound
  long wait_ = 0;  ///< looks before the implicit method is tried again
  long pause_ = 2; ///< and after the next trial
};

} // namespace vibroimpact::motion
