#include "analyses/curves/branch_table.h"

#include "analyses/results/fields.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::Special;
using continuation::SpecialPoint;

namespace {

std::string per(const std::string &unit) { return unit == "1" ? unit : "1/(" + unit + ")"; }

void add_special_values(const FieldWriter &row, const SpecialPoint &special,
                        const std::string &unit) {
  row.number("unstable_before", special.unstable_before, "1",
             "multipliers outside the unit circle on the side of smaller arclength");
  row.number("unstable_after", special.unstable_after, "1",
             "multipliers outside the unit circle on the side of larger arclength");
  row.number(
      "multiplier_slope", special.slope, per(unit),
      "derivative, by the key, of the multiplier that crosses the unit circle, of the modulus for "
      "a "
      "pair; where it is small the place is sensitive. 0 at other kinds");
  row.number(
      "key_width", special.width, unit,
      "change of the contact changes: of the interval of the key at whose end the point lies; 0 at "
      "other kinds, which are located");
}

} // namespace

BranchTable::BranchTable(const Label &key, RowOf row_of)
    : key_(key), row_of_(std::move(row_of)), rows_(key) {}

void BranchTable::begin(long number, long halves, double sign) {
  halves_ = halves;
  sign_ = sign;
  rows_.begin(number, sign);
}

PointResult BranchTable::orbit_of(const BranchPoint &point) {
  PointResult row = row_of_(point, halves_);
  if (!row.reason.empty())
    rows_.remark("the motion at " + rows_.at(point.point.keys) + " is not recorded: " + row.reason);
  return row;
}

void BranchTable::note_missing(double key, const std::string &why) {
  rows_.remark("the branch that begins at " + rows_.at(Vector::Constant(1, key)) +
               " is not followed: " + why);
}

void BranchTable::note_enclosed(const SpecialPoint &special) {
  std::ostringstream width;
  width.precision(2);
  width << special.width << (key_.unit() == "1" ? "" : " " + key_.unit());
  rows_.remark("the contact changes are others from " + rows_.at(special.at.point.keys) +
               " on, or up to " + width.str() +
               " before it, without a grazing motion that could be located");
}

void BranchTable::note_sliding(const SpecialPoint &special) {
  if (const std::string words = sliding_words(special); !words.empty())
    rows_.remark("contact " + special.graze->name + " at " + rows_.at(special.at.point.keys) +
                 ": " + words);
}

void BranchTable::end(const continuation::Branch &branch) {
  rows_.end(branch);
  stuck_ = stuck_ || (branch.end == continuation::End::least_step && branch.points.size() == 1);
  if (branch.end == continuation::End::least_step || branch.end == continuation::End::one_sided)
    rows_.remark("a branch ends at " + rows_.at(branch.points.back().point.keys) + ": " +
                 branch.reason);
}

void BranchTable::add_fields(PointResult &result) const {
  rows_.add_fields(result, "orbit_residual");
  result.reason = rows_.remarks();
}

void BranchTable::add(const BranchPoint &point) { rows_.add_point(point, orbit_of(point)); }

void BranchTable::add_frequency_fold(const BranchPoint &at) {
  SpecialPoint fold;
  fold.unstable_before = fold.unstable_after = at.unstable;
  PointResult values = orbit_of(at);
  add_special_values(values, fold, key_.unit());
  rows_.add_special(at, frequency_fold_kind(), std::move(values));
}

void BranchTable::add(const SpecialPoint &special) {
  SpecialPoint ordered = special;
  if (sign_ < 0)
    std::swap(ordered.unstable_before, ordered.unstable_after);
  if (special.kind == Special::pattern_change)
    note_enclosed(special);
  note_sliding(special);
  PointResult values = orbit_of(special.at);
  add_special_values(values, ordered, key_.unit());
  rows_.add_special(special.at, kind_number(special, halves_ % 2 != 0), std::move(values));
}

} // namespace vibroimpact::analyses
