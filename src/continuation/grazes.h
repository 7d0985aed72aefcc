// Grazes: where two smooth pieces of F meet, and how a branch goes on behind them.
//
// Where the least value g of a guard is zero, F_ext = 0 and g = 0, with F extended smoothly from
// the open side, is a regular system: Newton's method converges quadratically from either side.
// Behind a corner or a square root the tangent of the branch is another one, so that a step over
// the graze fails; the branch is then left at the graze and entered anew from there, by the depth
// of the touch (contact_side.h).
#pragma once

#include "continuation/special_points.h"

namespace vibroimpact::continuation {

/// The graze nearest to `guess`, at most `furthest` away; none where Newton's method finds none.
std::optional<LocatedGraze> locate_graze(const ScaledProblem &problem, const Vector &guess,
                                         double chart, const Graze &graze, double furthest,
                                         const Settings &settings);

/// Grazes between two nodes of different patterns, in their order.
std::vector<LocatedGraze> grazes_between(const ScaledProblem &problem, const Node &begin,
                                         const Node &end, const Settings &settings);

/// The branch beyond a graze that steps from `begin` do not pass.
struct Crossing {
  LocatedGraze graze;
  Node beyond;
  double step = 0; ///< from the graze, scaled
};
std::optional<Crossing> cross_graze(const ScaledProblem &problem, const Node &begin,
                                    const Settings &settings);

/// The graze close behind the last node at which a branch ends since there are no solutions behind
/// it.
std::optional<SpecialPoint> graze_that_ends(const ScaledProblem &problem, const Node &last,
                                            const Settings &settings);

/// The graze itself and the special points on both sides of it, each side with its own derivatives.
/// NumericalError where the guard has one sign at both nodes: a shorter step may do.
std::vector<SpecialPoint> special_points_across(const ScaledProblem &problem, const Node &begin,
                                                const LocatedGraze &graze, const Node &end,
                                                const Settings &settings);

} // namespace vibroimpact::continuation
