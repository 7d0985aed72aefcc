// What is kept of the motions of a harmonic balance along a key, as arrays.
#pragma once

#include "analyses/branch_rows.h"
#include "analyses/field_writer.h"
#include "analyses/kept_rows.h"
#include "analyses/keyed_balance.h"

namespace vibroimpact::analyses {

class BalanceTable {
public:
  /// Keeps references. Rows are steps of the record, if there is one.
  BalanceTable(const SweptParameter &parameter, KeyedBalance &system,
               continuation::HarmonicBalance &problem, StepRecord *steps);

  /// `sign`: -1 where the arclength falls.
  void begin(double sign) { rows_.begin(0, sign); }
  void add(const continuation::BranchPoint &point) { rows_.add_point(point, row_of(point)); }
  void add(const continuation::SpecialPoint &special);
  void end(const continuation::Branch &branch) { rows_.end(branch); }

  void add_fields(const FieldWriter &result) const { rows_.add_fields(result, "balance_residual"); }

private:
  PointResult row_of(const continuation::BranchPoint &point) {
    return kept_([&] { return values_of(point); });
  }
  PointResult values_of(const continuation::BranchPoint &point) const;
  void add_points(const continuation::HarmonicMotion &motion, const continuation::LeftOut &left,
                  const FieldWriter &row) const;
  void add_contacts(const continuation::HarmonicMotion &motion, const FieldWriter &row) const;

  KeyedBalance &system_;
  continuation::HarmonicBalance &problem_;
  KeptRows kept_;
  BranchRows rows_;
};

} // namespace vibroimpact::analyses
