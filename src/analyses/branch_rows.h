// What is known of a branch point by point, until all is there and becomes arrays: those of the
// points run along `branch_point`, of special points along `special_point`, of the ends along
// `branch_end`.
#pragma once

#include "analyses/curve_rows.h"
#include "analyses/field_writer.h"
#include "analyses/swept_parameter.h"
#include "continuation/branch.h"

namespace vibroimpact::analyses {

/// Of a kind in the field `special/kind`; a flip of half a symmetric motion loses the symmetry.
int kind_number(continuation::Special kind, bool symmetric = false);

class BranchRows {
public:
  /// Keeps a reference.
  explicit BranchRows(const SweptParameter &parameter);

  /// What follows is part of branch `number`; `sign`: -1 where the arclength falls.
  void begin(long number, double sign);
  /// All with the fields branch, arclength and key before those given.
  void add_point(const continuation::BranchPoint &point, PointResult values);
  /// `kind`: its number.
  void add_special(const continuation::BranchPoint &point, int kind, PointResult values);
  void end(const continuation::Branch &branch);
  /// Forgets all of a branch.
  void drop(long number);

  /// Arrays of everything; in the summary the number of points, and kind, key and field `residual`
  /// of each special point.
  void add_fields(const FieldWriter &result, const std::string &residual) const;

private:
  CurveRow row(const continuation::BranchPoint &point, PointResult values) const;

  Label key_, arclength_, branch_;
  long number_ = 0;
  double sign_ = 1;
  std::vector<CurveRow> points_, special_, ends_;
};

} // namespace vibroimpact::analyses
