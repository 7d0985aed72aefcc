// Special points of a step in which the pattern changes, wherever its ends lie.
//
// A graze is located from both ends of the step. It explains the change when the pattern close to
// it, on either side, is that of the end there. Where it does not, or no graze is found, the step
// is halved on its chord, so that each part with a change is looked at by itself. What is no graze
// is enclosed between two solutions.
#pragma once

#include "continuation/grazes.h"

namespace vibroimpact::continuation {

/// The same solution in another chart.
Node in_chart(const ScaledProblem &problem, const Node &node, double chart,
              const Settings &settings);

/// Between two nodes of different patterns. The arclength of the end becomes that through what is
/// found. NumericalError when several grazes lie close by: a shorter step may do.
std::vector<SpecialPoint> special_points_and_changes(const ScaledProblem &problem,
                                                     const Node &begin, Node &end,
                                                     const Settings &settings);

} // namespace vibroimpact::continuation
