// The linear map that an event makes of deviations.
//
// Where the guard g(x, t; p) ends a mode and the state is reset to R(x, t; p), the deviating motion
// arrives later by dt = -(g_x d + g_p) / g', so that (Mueller 1995)
//
//   d+ = R_x d- + R_p + (f+ - R') (g_x d- + g_p) / g'     f  dx/dt before (-) and after (+)
//                                                         ' total time derivatives along f-
//
// with d the derivative of the state by a key p; for deviations of the state alone g_p = R_p = 0. A
// change of a contact with friction through several modes at one instant is one such event, with f-
// before the first of them, f+ after the last, and g the guard passed first.
// Time-dependent gaps (moving bases) stand in g' and R'. A rigid impact resets the velocities, v+ =
// v- + M^-1 W^T i with impulses i that are linear in the gap rates before it. A contact that is let
// go from rest has no force at that instant: nothing jumps. At a break of the sources, whose
// instant t_b no state changes, d+ = d- + (f- - f+) dt_b/dp.
#pragma once

#include "motion/interval/observer.h"
#include "motion/variation/key_tangent.h"
#include "motion/variation/low_rank_map.h"

#include <limits>
#include <optional>

namespace vibroimpact::motion {

/// An event as a map, with what is needed to judge it beside others at the same instant.
struct Saltation {
  LowRankMap by_state;
  Matrix by_key;              ///< added to the derivatives by keys: physical_size() x keys
  RowVector delay;            ///< dt by a deviation before the event, -g_x / g'
  bool jumps = false;         ///< the map depends on the delay or resets something
  bool differentiable = true; ///< false: there is no derivative, and the map is one of several
};

class Saltations {
public:
  /// Keeps references. `equations` are changed to the modes on both sides of an event and left in
  /// those after it.
  Saltations(Equations &equations, const std::vector<KeyTangent *> &keys, const Vector &scale)
      : equations_(equations), keys_(keys), scale_(scale) {}

  /// Nothing where deviations pass unchanged. A collision of several contacts comes as several
  /// events, of which the first says all. `start`: of the motion; a mode that does not hold there
  /// is left at that instant by deviating motions too. NumericalError for collisions with rotors.
  std::optional<Saltation> of(const ContactEvent &event, double start);

  /// At a break of the sources, where the next one is `next`: physical_size() x keys to be added to
  /// the derivatives by the keys.
  Matrix at_break(const Vector &state, double next);

private:
  struct Crossing; // of a guard
  struct Reset;    // of the state
  struct LastChange {
    double time = std::numeric_limits<double>::quiet_NaN();
    RowVector delay, delay_by_key; ///< dt by state and keys
  };

  Vector rates(double time, const Vector &state) const;
  Vector rates_at_guard(const ContactEvent &event, const Vector &state) const;
  RowVector gradient(const ContactEvent &event, const contact::AffineForm &form) const;
  double rate_along(const contact::AffineForm &form, const ContactEvent &event,
                    const Vector &rates) const;
  double rate_of_forces(const contact::AffineForm &forces, const ContactEvent &event,
                        const Vector &rates) const;
  Crossing crossing(const ContactEvent &event, const Vector &before) const;
  Reset no_reset(const Vector &before) const;
  Reset internal_reset(const ContactEvent &event, const Vector &before) const;
  Reset impact(const ContactEvent &event, const Vector &before) const;
  Saltation join(Crossing crossing, Reset reset, const Vector &after) const;
  bool below_zero(const ContactEvent &event) const;
  Saltation change(const ContactEvent &event, bool at_start);
  Saltation collide(const ContactEvent &event);

  Equations &equations_;
  const std::vector<KeyTangent *> &keys_;
  const Vector &scale_;
  LastChange last_;
};

} // namespace vibroimpact::motion
