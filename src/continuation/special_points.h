// The special points on a smooth piece of a branch.
#pragma once

#include "continuation/piece.h"

namespace vibroimpact::continuation {

/// By arclength, each located; `after` is left to the branch. NumericalError when one is there and
/// cannot be located: a shorter piece may do.
std::vector<SpecialPoint> special_points(const ScaledProblem &problem, const Piece &piece,
                                         const Settings &settings);

/// A special point of this kind with its null vector, at a node between two others.
SpecialPoint make_special(const ScaledProblem &problem, Special kind, const Node &node,
                          const Node &before, const Node &after);

} // namespace vibroimpact::continuation
