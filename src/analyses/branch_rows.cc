#include "analyses/branch_rows.h"

#include "analyses/fields.h"

#include <utility>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::End;

namespace {

constexpr const char *special_kinds =
    "1 fold, 2 branch point, 3 period doubling, 4 loss of symmetry, 5 "
    "Neimark-Sacker, 6 graze, 7 grazing fold, 8 change of the contact "
    "changes";
constexpr const char *branch_ends =
    "0 lower end of the key, 1 upper end of the key, 2 the branch "
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

CurveRow BranchRows::row(const BranchPoint &point, PointResult values) const {
  CurveRow row{.arclength = sign_ * point.arclength, .curve = number_, .values = std::move(values)};
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
  special_.back().values.fields.push_back(scalar_field("kind", kind, "1", special_kinds));
}

void BranchRows::end(const continuation::Branch &branch) {
  if (branch.points.empty())
    return;
  const BranchPoint &last = branch.points.back();
  CurveRow row{.arclength = sign_ * last.arclength, .curve = number_};
  row.values.fields = {scalar_field(branch_, static_cast<double>(number_)),
                       scalar_field(key_, last.point.keys[0]),
                       scalar_field("reason", number_of(branch.end), "1", branch_ends)};
  ends_.push_back(std::move(row));
}

void BranchRows::drop(long number) {
  for (std::vector<CurveRow> *rows : {&points_, &special_, &ends_})
    std::erase_if(*rows, [number](const CurveRow &row) { return row.curve == number; });
}

void BranchRows::add_fields(PointResult &result, const std::string &residual) const {
  const std::vector<PointResult> special = in_order(special_);
  add_rows(result, in_order(points_), "branch_point", "");
  add_rows(result, special, "special_point", "special/");
  add_rows(result, in_order(ends_), "branch_end", "end/");
  result.summary.push_back(scalar_line("points", static_cast<double>(points_.size()), "1"));
  summarise_special(result, special, {"kind", key_.name(), residual});
}

} // namespace vibroimpact::analyses
