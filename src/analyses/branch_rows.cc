#include "analyses/branch_rows.h"

#include "analyses/fields.h"
#include "analyses/stacked_points.h"

#include <algorithm>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::End;

namespace {

constexpr const char *kinds = "1 fold, 2 branch point, 3 period doubling, 4 loss of symmetry, 5 "
                              "Neimark-Sacker, 6 graze, 7 grazing fold, 8 change of the contact "
                              "changes";
constexpr const char *reasons = "0 lower end of the key, 1 upper end of the key, 2 the branch "
                                "closes on itself, 3 it falls onto motions of a smaller multiple, "
                                "4 least step, 5 most points, 6 a graze it returns to again and "
                                "again, 7 the motion grows beyond all measure";

int number_of(End end) {
  switch (end) {
  case End::lower_bound:
    return 0;
  case End::upper_bound:
    return 1;
  case End::closed:
    return 2;
  case End::shorter_return:
    return 3;
  case End::least_step:
    return 4;
  case End::most_points:
    return 5;
  case End::graze:
    return 6;
  case End::far:
    return 7;
  }
  return -1;
}

} // namespace

BranchRows::BranchRows(const SweptParameter &parameter)
    : key_(parameter.axis_name(), parameter.unit, parameter.axis().description),
      arclength_("arclength", "1",
                 "from the start of the branch, in unknowns made comparable; negative behind it"),
      branch_("branch", "1",
              "number of the branch: 0 is that of the start, the others begin at "
              "special points") {}

void BranchRows::begin(long number, double sign) {
  number_ = number;
  sign_ = sign;
}

BranchRows::Row BranchRows::row(const BranchPoint &point, PointResult values) const {
  Row row{.arclength = sign_ * point.arclength, .branch = number_, .values = std::move(values)};
  const std::vector<Field> place = {scalar_field(branch_, static_cast<double>(number_)),
                                    scalar_field(arclength_, row.arclength),
                                    scalar_field(key_, point.point.keys[0])};
  row.values.fields.insert(row.values.fields.begin(), place.begin(), place.end());
  return row;
}

void BranchRows::add_point(const BranchPoint &point, PointResult values) {
  points_.push_back(row(point, std::move(values)));
}

void BranchRows::add_special(const BranchPoint &point, int kind, PointResult values) {
  special_.push_back(row(point, std::move(values)));
  special_.back().values.fields.push_back(scalar_field("kind", kind, "1", kinds));
}

void BranchRows::end(const continuation::Branch &branch) {
  if (branch.points.empty())
    return;
  const BranchPoint &last = branch.points.back();
  Row row{.arclength = sign_ * last.arclength, .branch = number_};
  row.values.fields = {scalar_field(branch_, static_cast<double>(number_)),
                       scalar_field(key_, last.point.keys[0]),
                       scalar_field("reason", number_of(branch.end), "1", reasons)};
  ends_.push_back(std::move(row));
}

void BranchRows::drop(long number) {
  for (std::vector<Row> *rows : {&points_, &special_, &ends_})
    std::erase_if(*rows, [number](const Row &row) { return row.branch == number; });
}

std::vector<PointResult> BranchRows::in_order(std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row &a, const Row &b) {
    return std::pair(a.branch, a.arclength) < std::pair(b.branch, b.arclength);
  });
  std::vector<PointResult> values;
  values.reserve(rows.size());
  for (Row &row : rows)
    values.push_back(std::move(row.values));
  return values;
}

void BranchRows::add_fields(PointResult &result, const std::string &residual) const {
  const auto add = [&result](const std::vector<PointResult> &rows, const char *dimension,
                             const char *prefix) {
    for (Field &field : stacked(rows, dimension, prefix))
      result.fields.push_back(std::move(field));
  };
  add(in_order(points_), "branch_point", "");
  const std::vector<PointResult> special = in_order(special_);
  add(special, "special_point", "special/");
  add(in_order(ends_), "branch_end", "end/");
  result.summary.push_back(scalar_line("points", static_cast<double>(points_.size()), "1"));
  for (std::size_t i = 0; i < special.size(); ++i)
    for (const Field &field : special[i].fields)
      if (field.name() == "kind" || field.label == key_ || field.name() == residual)
        result.summary.push_back(
            scalar_line("special[" + std::to_string(i + 1) + "]." + field.name(), field.values[0],
                        field.unit()));
}

} // namespace vibroimpact::analyses
