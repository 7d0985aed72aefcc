// Deviations over the first or last instants of a nonlinear contact.
//
// Where a contact begins or ends at gap = 0 the slope of its force may be infinite there (of
// Kuwabara-Kono u^(-1/2), of Tsuji u^(-3/4) at the penetration u), and what rounding makes of the
// gap would show in the integral of J d. A deviation is therefore split into a shift of time and a
// rest,
//
//   d = a f + e,   a = (row d_q + d gap/dp) / gap',   f = dx/dt
//
// The shift, whose a f only takes the rates at both ends, takes all of the deviation of the gap, so
// that e meets the slope c s^-q with a gap deviation that grows with the time s from there: what
// that gives is the integral of c s^(1 - q). All else is smooth and taken by the midpoint rule.
// The time is short beside that of the contact, dF/dgap dt^2 <= 10^-8 m with the effective mass m,
// and beside the model's own.
#pragma once

#include "motion/variation/key_tangent.h"

#include <optional>

namespace vibroimpact::motion {

struct VanishingGap {
  std::size_t contact = 0;
  double duration = 0; ///< for which cross() is made [s]
};

/// A contact that acts, whose gap is as good as zero at `time`, one end of a step of the given
/// duration [s], and whose force has an infinite slope there.
std::optional<VanishingGap> vanishing_gap(const Equations &equations, double time,
                                          const Vector &state, double duration);

struct ShortInterval {
  std::size_t contact = 0; ///< whose gap vanishes at one end
  double zero = 0;         ///< when it does [s]
  double other = 0;        ///< the other end [s]
  Vector state_at_zero;    ///< with work integrals
};

/// The state at the other end, by the midpoint rule.
Vector state_at_other(const Equations &equations, const ShortInterval &interval);

/// Takes the columns from one end to the other, forward in time: from the instant at which the gap
/// vanishes where that is the earlier one. The last columns belong to `keys`. Returns
/// the integral of the divergence.
double cross(const Equations &equations, const std::vector<KeyTangent *> &keys,
             const ShortInterval &interval, Matrix &columns);

} // namespace vibroimpact::motion
