// The force of a contact along a gap that is a Fourier series, as a Fourier series.
//
// The law passes through its modes as in a motion: where one of its guards falls through zero the
// instant is located, and between these instants the force is smooth. Its coefficients are
// integrals over the parts, with their derivatives by those of the gap: of an integral from t_a to
// t_b of f w,
//
//     d/dy = integral of (df/dy) w + f(t_b) w(t_b) dt_b/dy - f(t_a) w(t_a) dt_a/dy,
//
// so that they are smooth functions of the gap even where the force jumps (Petrov & Ewins 2003 do
// so for friction). Equal samples over the period would leave steps of the height of the jump over
// their number. Internal states of the law follow their equation by collocation, and are carried on
// from period to period until they repeat themselves.
#pragma once

#include "contact/contact_set.h"
#include "periodic/harmonic_grid.h"

namespace vibroimpact::periodic {

struct ContactSeries {
  RowVector force;    ///< coefficients of the normal force, 2 H + 1 [N]
  Matrix by_gap;      ///< their derivatives by those of the gap; empty unless wanted
  double largest = 0; ///< normal force, by parabolas through its values at the nodes [N]
};

/// `gap`: coefficients on this grid, the clearance included. NumericalError when the law changes
/// its mode without end, or its internal states do not repeat themselves.
ContactSeries contact_series(const contact::ContactPair &pair, const RowVector &gap,
                             double frequency, const HarmonicGrid &grid, bool slopes = true);

} // namespace vibroimpact::periodic
