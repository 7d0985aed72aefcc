// Rows of values along curves whose number of points is known only in the end.
#pragma once

#include "analyses/stacked_points.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// A row at its place along one of several curves.
struct CurveRow {
  double arclength = 0;
  long curve = 0;
  PointResult values{};
};
/// By curve and arclength.
std::vector<PointResult> in_order(std::vector<CurveRow> rows);

} // namespace vibroimpact::analyses
