// Rows of branches: their points, special points and ends.
#pragma once

#include "analyses/keys/swept_parameter.h"
#include "analyses/results/curve_table.h"
#include "continuation/branch.h"

namespace vibroimpact::analyses {

/// Of a kind in the field `special/kind`; a flip of half a symmetric motion loses the symmetry.
int kind_number(continuation::Special kind, bool symmetric = false);
/// The same of a point; sides that rub have kinds of their own.
int kind_number(const continuation::SpecialPoint &special, bool symmetric);
int frequency_fold_kind();
/// What becomes of a motion with friction behind a point; empty at all other kinds.
std::string sliding_words(const continuation::SpecialPoint &special);

/// Of a key that a branch runs along.
Label key_label(const SweptParameter &parameter);

class BranchRows : public CurveTable {
public:
  explicit BranchRows(const Label &key);

  void add_point(const continuation::BranchPoint &point, PointResult values);
  /// `kind`: its number.
  void add_special(const continuation::BranchPoint &point, int kind, PointResult values);
  void end(const continuation::Branch &branch);
  /// In the summary kind, key and field `residual` of each special point.
  void add_fields(const FieldWriter &result, const std::string &residual) const;
};

} // namespace vibroimpact::analyses
