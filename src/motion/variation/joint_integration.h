// Deviations in a phase that is not linear: integrated together with the motion.
//
//   x' = f(x, t),   d' = J(x, t) d,   d' = J d + df/dp for the derivative by a key,   (int tr J)'
//
// all under one error control. The state is integrated again from the start of each step, since the
// dense output of a step is less accurate than its ends, which the Jacobian of a stiff contact
// would make worse.
#pragma once

#include "motion/interval/observer.h"
#include "motion/variation/key_tangent.h"
#include "motion/variation/linear_flow.h"

namespace vibroimpact::motion {

/// What deviations are measured by and how exactly.
struct VariationAccuracy {
  Vector scale; ///< physical_size() factors that make entries of the state comparable
  /// Error of a step, relative to the largest scaled entry of each column; a hundred times that for
  /// derivatives by keys; of the state relative to its change in the step.
  double tolerance = 1e-10;
};

/// A part of the motion without events.
struct SmoothPart {
  double start = 0, end = 0; ///< [s]
  Vector start_state, end_state;
  bool from_event = false, to_event = false; ///< contacts change at the start, at the end
  double length() const { return end - start; }
};

/// Takes the columns from the start of the part to its end; the last ones belong to `keys`. Returns
/// the integral of the divergence tr J over the part. `free`: the phase in which the nonlinear
/// contacts have no force; with it columns that these do not observe are not integrated.
double integrate_beside(const SmoothPart &part, const Equations &equations,
                        const std::vector<KeyTangent *> &keys, const VariationAccuracy &accuracy,
                        LinearFlow *free, Matrix &columns);

} // namespace vibroimpact::motion
