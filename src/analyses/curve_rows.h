// Rows of values along curves whose number of points is known only in the end.
#pragma once

#include "common/result_sink.h"

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
/// Rows as arrays along a dimension; names get the prefix.
void add_rows(PointResult &result, const std::vector<PointResult> &rows, const char *dimension,
              const char *prefix);
/// Some of the values of special points, by name, as summary lines.
void summarise_special(PointResult &result, const std::vector<PointResult> &special,
                       const std::vector<std::string> &names);

} // namespace vibroimpact::analyses
