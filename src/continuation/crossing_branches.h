// Where two branches cross: the point of a branch at which [F_x F_p] loses rank.
#pragma once

#include "continuation/piece.h"

namespace vibroimpact::continuation {

/// Between two nodes whose test det [F_u; t] has opposite signs; `u` and the linearisation there.
/// None where Newton's method finds none between them.
std::optional<Corrected> crossing_between(const ScaledProblem &problem, const Piece &piece,
                                          const Settings &settings);

} // namespace vibroimpact::continuation
