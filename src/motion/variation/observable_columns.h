// Deviations that nonlinear contacts observe.
//
// Over a part of a step of length h, with A the generator of the phase in which the nonlinear
// contacts have no force, deviations obey
//
//   d' = A d + sum_c b_c f_c(t),   f_c linear in gap, gap rate and internal states of the contact
//
// Where all of these, rows w, stay zero under e^(A s), 0 <= s <= h, the contacts add nothing and
// d(h) = e^(A h) d(0) in closed form. The rows
//
//   w e^(A s) = sum_k (s / h)^k w (A h)^k / k!
//
// span few dimensions where the part is short beside the periods of the modes, however many modes
// there are: the unobservable subspace of (A, w) is large. With an orthonormal basis V of them,
// columns D = V (V^T D) + (D - V V^T D), only V has to be integrated beside the motion.
#pragma once

#include "motion/system/equations.h"
#include "motion/variation/linear_flow.h"

#include <optional>

namespace vibroimpact::motion {

struct ObservableColumns {
  Matrix basis;        ///< V: n x k
  Matrix coefficients; ///< of the columns: k x columns
  Matrix rest;         ///< what is left of the columns, at the end of the part: n x columns
};

/// In the present modes of the equations, over h [s], backward where negative. `free`: the phase
/// without forces of nonlinear contacts. Nothing where V would not be much smaller than the
/// columns.
std::optional<ObservableColumns> observable_columns(const Equations &equations, LinearFlow &free,
                                                    const Vector &scale, double h,
                                                    const Matrix &columns);

} // namespace vibroimpact::motion
