#include "analyses/curve_rows.h"

#include <algorithm>

namespace vibroimpact::analyses {

std::vector<PointResult> in_order(std::vector<CurveRow> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const CurveRow &a, const CurveRow &b) {
    return std::pair(a.curve, a.arclength) < std::pair(b.curve, b.arclength);
  });
  std::vector<PointResult> values;
  values.reserve(rows.size());
  for (CurveRow &row : rows)
    values.push_back(std::move(row.values));
  return values;
}

} // namespace vibroimpact::analyses
