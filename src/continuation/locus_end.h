// Ends of curves of folds and flips on grazing curves.
//
// Where a touch is a corner, the multipliers jump at the graze, and a curve of folds or flips ends
// where the multiplier of its side is 1 or -1 on the grazing curve itself. Steps towards it shorten
// without end, since derivatives behind the corner run as the square root of the depth; with the
// derivatives at the corner the end is a regular point of
//
//     F_ext = 0,  g_min = 0,  J -+ I singular,   J = J_ext on the open side, J_ext + jump grad
//     g_min behind.
#pragma once

#include "continuation/locus_system.h"

namespace vibroimpact::continuation {

struct GrazeEnd {
  Vector u;
  Linearisation at; ///< of the extension
  Graze graze;
};

/// The end nearest to the last point of a curve; none where no guard is about to touch.
std::optional<GrazeEnd> end_at_graze(const ScaledProblem &problem, LocusKind kind,
                                     const LocusNode &last, const Settings &settings);

} // namespace vibroimpact::continuation
