#include "analyses/curves/branch_rows.h"

#include "analyses/results/coded.h"
#include "periodic/graze_extension.h"

#include <utility>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::End;
using continuation::Special;
using continuation::SpecialPoint;
using periodic::GrazeKind;

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

// Of sides that rub, behind all others.
constexpr Coded<GrazeKind> sliding_kinds[] = {
    {GrazeKind::crossing_sliding, 9, "crossing-sliding"},
    {GrazeKind::grazing_sliding, 10, "grazing-sliding"},
    {GrazeKind::switching_sliding, 11, "switching-sliding"},
    {GrazeKind::adding_sliding, 12, "adding-sliding"}};

// Of motions that no excitation times, along another key.
enum class FreeKind { frequency_fold };
constexpr Coded<FreeKind> free_kinds[] = {{FreeKind::frequency_fold, 13, "fold of the frequency"}};

GrazeKind graze_kind(const SpecialPoint &special) {
  return special.graze ? static_cast<GrazeKind>(special.graze->kind) : GrazeKind::contact;
}

constexpr Coded<End> branch_ends[] = {
    {End::lower_bound, 0, "lower end of the key"},
    {End::upper_bound, 1, "upper end of the key"},
    {End::closed, 2, "the branch closes on itself"},
    {End::shorter_return, 3, "it falls onto motions of a smaller multiple"},
    {End::least_step, 4, "least step"},
    {End::most_points, 5, "most points"},
    {End::graze, 6, "returns repeatedly to the same grazing motion"},
    {End::far, 7, "the motion grows beyond all measure"},
    {End::one_sided, 8, "no motion close by behind a grazing point"}};

} // namespace

// Behind each kind of flip stands that of symmetric motions.
int kind_number(Special kind, bool symmetric) {
  return code_of(special_kinds, kind) + (symmetric && kind == Special::flip ? 1 : 0);
}

int kind_number(const SpecialPoint &special, bool symmetric) {
  const GrazeKind kind = graze_kind(special);
  return kind == GrazeKind::contact ? kind_number(special.kind, symmetric)
                                    : code_of(sliding_kinds, kind);
}

int frequency_fold_kind() { return code_of(free_kinds, FreeKind::frequency_fold); }

std::string sliding_words(const SpecialPoint &special) {
  switch (graze_kind(special)) {
  case GrazeKind::contact:
    return "";
  case GrazeKind::crossing_sliding:
    return "crossing-sliding point: on one side the slip turns round at once, on the other the "
           "sides "
           "stick in between";
  case GrazeKind::grazing_sliding:
    return "grazing-sliding point: the slip rate just reaches zero, and on one side the sides "
           "stick "
           "then";
  case GrazeKind::switching_sliding:
    return "switching-sliding point: where the sides come to stick, on one side they slip the "
           "other way "
           "for a moment first";
  case GrazeKind::adding_sliding:
    return "adding-sliding point: on one side the sides slip for a moment in the middle of a stick";
  }
  return "";
}

Label key_label(const SweptParameter &parameter) {
  return {parameter.axis_name(), parameter.unit, parameter.axis().description};
}

BranchRows::BranchRows(const Label &key)
    : CurveTable("branch",
                 "number of the branch: 0 is that of the start, the others begin at special points",
                 {key}) {}

void BranchRows::add_point(const BranchPoint &point, PointResult values) {
  add(Part::point, point.point.keys, point.arclength, std::move(values));
}

void BranchRows::add_special(const BranchPoint &point, int kind, PointResult values) {
  FieldWriter(values).number("kind", kind, "1",
                             meaning_of(special_kinds) + ", " + meaning_of(sliding_kinds) + ", " +
                                 meaning_of(free_kinds));
  add(Part::special, point.point.keys, point.arclength, std::move(values));
}

void BranchRows::end(const continuation::Branch &branch) {
  if (branch.points.empty())
    return;
  PointResult values;
  FieldWriter(values).number("reason", code_of(branch_ends, branch.end), "1",
                             meaning_of(branch_ends));
  const BranchPoint &last = branch.points.back();
  add(Part::end, last.point.keys, last.arclength, std::move(values));
}

void BranchRows::add_fields(const FieldWriter &result, const std::string &residual) const {
  CurveTable::add_fields(result, {"kind", keys()[0].name(), residual});
}

} // namespace vibroimpact::analyses
