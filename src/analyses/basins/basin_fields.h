// Fields of basins of attraction that several analyses share.
#pragma once

#include "analyses/basins/basin_search.h"
#include "analyses/results/field_writer.h"

namespace vibroimpact::analyses {

// What a start is marked with that leads to none of the attractors.
inline constexpr double undecided = -1, no_motion = -2, another = -3;

/// Place of the attractor, or a mark. Attractors from `known` on count as others.
double mark_of(const periodic::Decision &decision, std::size_t known);

/// Share of the starts for each attractor and each mark; `of`: of what, for the descriptions.
void add_shares(const FieldWriter &result, const std::vector<double> &marks, std::size_t known,
                const std::string &of);
/// Multiple, largest multiplier and state of the first `known` attractors.
void add_attractors(const FieldWriter &result, const BasinSearch &search, std::size_t known);

} // namespace vibroimpact::analyses
