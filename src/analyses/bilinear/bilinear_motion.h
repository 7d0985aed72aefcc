// Motions that close a contact once in each period, stay tied, and open it once.
//
// Let the contact close at the forcing phase theta and stay tied over the angle sigma. The state
// y = [x, u] with u = [1, sin theta, cos theta] before closing returns after the period,
//
//   y = Phi_open(2 pi - sigma) Phi_closed(sigma) P y
//
// P the inelastic impact. The upper rows are linear equations for x, so that x = X(sigma) u. Two
// conditions are left: the gap is zero at closing and the force at opening,
//
//   [gap; force Phi_closed(sigma) P] [X; I] u = a + B [sin theta; cos theta] = 0
//
// Where B [sin; cos] = -a and sin^2 + cos^2 = 1, det(B)^2 = |adj(B) a|^2: one equation in sigma
// alone, which falls into det B + |adj(B) a| = 0 and det B - |adj(B) a| = 0. Every change of sign
// of both on a grid of sigma is refined to rounding.
#pragma once

#include "analyses/bilinear/tied_system.h"

#include <numbers>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

inline constexpr double full_turn = 2 * std::numbers::pi; ///< of the phase [rad]

struct BilinearMotion {
  bool closes = false;           ///< once in each period; else it is always open or always tied
  double contact_angle = 0;      ///< sigma [rad]; 2 pi where it is always tied
  double closing_phase = 0;      ///< theta in [0, 2 pi) [rad]
  Vector closed_start;           ///< y after closing; where it never closes, y at phase zero
  Vector open_start;             ///< y at opening
  double approach_speed = 0;     ///< at closing [m/s]
  double largest_multiplier = 0; ///< modulus; of the period, closing and opening included
  /// Why it is no motion of a contact that can only push; empty when it is one.
  std::string objection{};

  bool admissible() const { return objection.empty(); }
};

/// All, the always open and the always tied motion too. `cells`: of the grid of sigma;
/// `samples`: of the period, for objections.
std::vector<BilinearMotion> bilinear_motions(const TiedSystem &system, std::size_t cells,
                                             std::size_t samples);

/// y at the angles tau (growing, [0, 2 pi]) of the forcing, one column each.
Matrix states_of(const TiedSystem &system, const BilinearMotion &motion, const Vector &angles);
/// Does the motion stand closed there?
bool is_closed(const BilinearMotion &motion, double angle);

struct FormRange {
  double minimum = 0, maximum = 0;
};
/// Extreme values of forms of y (rows) over the part of the period in which the contact is open and
/// that in which it is tied; empty parts have minimum > maximum. Extremes are refined between
/// `samples` per period.
std::vector<FormRange> ranges(const TiedSystem &system, const BilinearMotion &motion,
                              const std::vector<RowVector> &forms, bool closed,
                              std::size_t samples);

} // namespace vibroimpact::analyses
