#include "analyses/curve_rows.h"

#include "analyses/fields.h"
#include "analyses/stacked_points.h"

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

void add_rows(PointResult &result, const std::vector<PointResult> &rows, const char *dimension,
              const char *prefix) {
  for (Field &field : stacked(rows, dimension, prefix))
    result.fields.push_back(std::move(field));
}

void summarise_special(PointResult &result, const std::vector<PointResult> &special,
                       const std::vector<std::string> &names) {
  for (std::size_t i = 0; i < special.size(); ++i)
    for (const Field &field : special[i].fields)
      if (std::find(names.begin(), names.end(), field.name()) != names.end())
        result.summary.push_back(
            scalar_line("special[" + std::to_string(i + 1) + "]." + field.name(), field.values[0],
                        field.unit()));
}

} // namespace vibroimpact::analyses
