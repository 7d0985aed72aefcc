#include "analyses/branch_rows.h"

#include "analyses/coded.h"

#include <utility>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::End;
using continuation::Special;

namespace {

constexpr Coded<Special> special_kinds[] = {
    {Special::fold, 1, "fold"},
    {Special::branch_point, 2, "branch point"},
    {Special::flip, 3, "period doubling"},
    {Special::flip, 4, "loss of symmetry"},
    {Special::neimark_sacker, 5, "Neimark-Sacker"},
    {Special::graze, 6, "graze"},
    {Special::grazing_fold, 7, "grazing fold"},
    {Special::pattern_change, 8, "change of the contact changes"}};

constexpr Coded<End> branch_ends[] = {
    {End::lower_bound, 0, "lower end of the key"},
    {End::upper_bound, 1, "upper end of the key"},
    {End::closed, 2, "the branch closes on itself"},
    {End::shorter_return, 3, "it falls onto motions of a smaller multiple"},
    {End::least_step, 4, "least step"},
    {End::most_points, 5, "most points"},
    {End::graze, 6, "a graze it returns to again and again"},
    {End::far, 7, "the motion grows beyond all measure"}};

} // namespace

// Behind each kind of flip stands that of symmetric motions.
int kind_number(Special kind, bool symmetric) {
  return code_of(special_kinds, kind) + (symmetric && kind == Special::flip ? 1 : 0);
}

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
  CurveRow row{.arclength = sign_ * point.arclength, .curve = number_};
  const FieldWriter fields(row.values);
  fields.number(branch_, static_cast<double>(number_));
  fields.number(arclength_, row.arclength);
  fields.number(key_, point.point.keys[0]);
  std::move(values.fields.begin(), values.fields.end(), std::back_inserter(row.values.fields));
  return row;
}

void BranchRows::add_point(const BranchPoint &point, PointResult values) {
  points_.push_back(row(point, std::move(values)));
}

void BranchRows::add_special(const BranchPoint &point, int kind, PointResult values) {
  special_.push_back(row(point, std::move(values)));
  FieldWriter(special_.back().values).number("kind", kind, "1", meaning_of(special_kinds));
}

void BranchRows::end(const continuation::Branch &branch) {
  if (branch.points.empty())
    return;
  const BranchPoint &last = branch.points.back();
  CurveRow row{.arclength = sign_ * last.arclength, .curve = number_};
  const FieldWriter fields(row.values);
  fields.number(branch_, static_cast<double>(number_));
  fields.number(key_, last.point.keys[0]);
  fields.number("reason", code_of(branch_ends, branch.end), "1", meaning_of(branch_ends));
  ends_.push_back(std::move(row));
}

void BranchRows::drop(long number) {
  for (std::vector<CurveRow> *rows : {&points_, &special_, &ends_})
    std::erase_if(*rows, [number](const CurveRow &row) { return row.curve == number; });
}

void BranchRows::add_fields(const FieldWriter &result, const std::string &residual) const {
  const std::vector<PointResult> special = in_order(special_);
  add_stacked(result, in_order(points_), "branch_point");
  add_stacked(result.below("special/"), special, "special_point");
  add_stacked(result.below("end/"), in_order(ends_), "branch_end");
  result.line("points", static_cast<double>(points_.size()), "1");
  summarise(result, "special", special, {"kind", key_.name(), residual});
}

} // namespace vibroimpact::analyses
