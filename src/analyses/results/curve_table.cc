#include "analyses/results/curve_table.h"

#include <algorithm>
#include <sstream>

namespace vibroimpact::analyses {

CurveTable::CurveTable(const std::string &curve, const std::string &numbering,
                       std::vector<Label> keys)
    : name_(curve), curve_(curve, "1", numbering),
      arclength_("arclength", "1",
                 "from the start of the " + curve +
                     ", in unknowns made comparable; negative behind it"),
      keys_(std::move(keys)) {}

void CurveTable::begin(long number, double sign) {
  number_ = number;
  sign_ = sign;
}

void CurveTable::add(Part part, const Vector &keys, double arclength, PointResult values) {
  Row row{.curve = number_, .arclength = sign_ * arclength};
  const FieldWriter fields(row.values);
  fields.number(curve_, static_cast<double>(number_));
  if (part != Part::end)
    fields.number(arclength_, row.arclength);
  for (std::size_t k = 0; k < keys_.size(); ++k)
    fields.number(keys_[k], keys[static_cast<Index>(k)]);
  std::move(values.fields.begin(), values.fields.end(), std::back_inserter(row.values.fields));
  rows_[static_cast<std::size_t>(part)].push_back(std::move(row));
}

void CurveTable::drop(long number) {
  for (std::vector<Row> &rows : rows_)
    std::erase_if(rows, [number](const Row &row) { return row.curve == number; });
}

// By curve and arclength.
std::vector<PointResult> CurveTable::in_order(Part part) const {
  std::vector<Row> rows = rows_[static_cast<std::size_t>(part)];
  std::stable_sort(rows.begin(), rows.end(), [](const Row &a, const Row &b) {
    return std::pair(a.curve, a.arclength) < std::pair(b.curve, b.arclength);
  });
  std::vector<PointResult> values;
  values.reserve(rows.size());
  for (Row &row : rows)
    values.push_back(std::move(row.values));
  return values;
}

std::string CurveTable::at(const Vector &keys) const {
  std::ostringstream text;
  text.precision(10);
  for (std::size_t k = 0; k < keys_.size(); ++k)
    text << (k == 0 ? "" : ", ") << keys_[k].name() << " = " << keys[static_cast<Index>(k)]
         << (keys_[k].unit() == "1" ? "" : " " + keys_[k].unit());
  return text.str();
}

std::string CurveTable::remarks() const {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, remarks_.size()); ++i)
    text += (i == 0 ? "" : "; ") + remarks_[i];
  if (remarks_.size() > most)
    text += "; and " + std::to_string(remarks_.size() - most) + " others";
  return text;
}

void CurveTable::add_fields(const FieldWriter &result,
                            const std::vector<std::string> &summarised) const {
  const std::vector<PointResult> points = in_order(Part::point), special = in_order(Part::special);
  add_stacked(result, points, (name_ + "_point").c_str());
  add_stacked(result.below("special/"), special, "special_point");
  add_stacked(result.below("end/"), in_order(Part::end), (name_ + "_end").c_str());
  result.line("points", static_cast<double>(points.size()), "1");
  summarise(result, "special", special, summarised);
}

} // namespace vibroimpact::analyses
