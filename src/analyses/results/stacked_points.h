// Many points as arrays with one dimension more, for results whose number is not known beforehand.
#pragma once

#include "analyses/results/field_writer.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// The fields of all points, by name: `dimension` comes first in each, then the field's own. What a
/// point does not have, or has shorter than others, is NaN.
void add_stacked(const FieldWriter &result, const std::vector<PointResult> &points,
                 const std::string &dimension);

/// Numbers of these names as lines `KIND[1].NAME`, `KIND[2].NAME` of the summary.
void summarise(const FieldWriter &result, const std::string &kind,
               const std::vector<PointResult> &points, const std::vector<std::string> &names);

/// Copies the values of the field, row-major, into the corner of a larger block of shape `full`.
void copy_block(const Field &field, const std::vector<std::size_t> &full, double *target);

} // namespace vibroimpact::analyses
