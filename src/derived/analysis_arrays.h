// The points of an analysis put together to labelled arrays over its outer axes. Depends only on
// the header and the points, not on ranks or the order in which they came.
#pragma once

#include "common/hdf5_file.h"
#include "common/result_sink.h"
#include "derived/labelled_array.h"

#include <functional>

namespace vibroimpact::derived {

/// Calls `visit` for the points of an analysis in the order of their index. A point is valid until
/// `visit` returns.
using PointSequence = std::function<void(const std::function<void(const PointResult &)> &visit)>;

/// One field over all points: outer axes first, then its own dimensions.
struct AssembledField {
  Label label;
  bool over_axes = true; ///< false for a coordinate: the same in all points, stored once
  Shape inner_shape{};   ///< of one point
  Shape shape{};
  std::vector<double> values{}; ///< row-major; NaN where a point is missing, failed or shorter

  const std::string &name() const { return label.name(); }
  /// Names of the inner dimensions; their scales are in AnalysisArrays.
  const std::vector<std::string> &inner_dimensions() const { return label.dimensions(); }
};

/// One inner dimension of the fields.
struct InnerDimension {
  std::string name;
  std::size_t length = 0; ///< of the longest point
  /// Field that holds its coordinate; empty when it is counted by an index from 1.
  std::string coordinate;
};

struct AnalysisArrays {
  std::vector<InnerDimension> dimensions; ///< in order of appearance
  std::vector<AssembledField> fields;     ///< in order of appearance
  std::vector<std::int64_t> status;       ///< over the outer axes
  std::vector<std::string> reason;        ///< over the outer axes
};

/// Lengths of the outer axes.
Shape outer_shape(const AnalysisHeader &header);

/// Throws std::logic_error when a point lies outside the axes, when a field's values do not fill
/// its shape, or when two points give a field different dimensions.
void check_point(const AnalysisHeader &header, const PointResult &result);

/// Goes through the points up to three times.
AnalysisArrays assemble(const AnalysisHeader &header, const PointSequence &points);

/// Looks at the values in `arrays`, which must outlive it.
Source derivation_source(const AnalysisHeader &header, const AnalysisArrays &arrays);

} // namespace vibroimpact::derived
