// Impulses of several rigid contacts at one instant, and the forces of several contacts at rest.
//
// Both are linear complementarity problems in contact space. With G = W M^-1 W^T, row i of W the
// gap row of contact i and M the mass matrix, impulses p change the gap rates by G p and forces F
// the second derivatives of the gaps by G F. No contact pulls, so that Newton's rule reads, for
// each contact,
//
//   0 <= p,   gap_rate+ >= b,   p (gap_rate+ - b) = 0,     b = e max(0, -gap_rate-)
//
// A contact whose neighbours push it apart faster than its own rule asks gets no impulse. Among
// contacts that approach or rest energy does not grow: the impulses change it by
// p . (gap_rate+ + gap_rate-) / 2 = sum of p (1 - e) gap_rate- / 2 <= 0. A contact that parts
// already must not take part.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::contact {

/// The x >= 0 with G x + q >= 0 and x . (G x + q) = 0. G symmetric and positive semi-definite. It
/// minimises x . G x / 2 + q . x; G x is unique even where G is singular (one contact listed
/// twice), x then is not. Active sets, finite. NumericalError when there is no solution: the
/// contacts ask for motions that exclude each other.
Vector solve_complementarity(const Matrix &matrix, const Vector &q);

/// Impulses by Newton's rule. `gap_rates`: before; `wanted`: b, at least so large afterwards.
inline Vector newton_impulses(const Matrix &matrix, const Vector &gap_rates, const Vector &wanted) {
  return solve_complementarity(matrix, gap_rates - wanted);
}

} // namespace vibroimpact::contact
