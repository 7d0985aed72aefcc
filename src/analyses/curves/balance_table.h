// What is kept of the motions of a harmonic balance along a key, as arrays.
#pragma once

#include "analyses/curves/branch_follower.h"
#include "analyses/curves/branch_rows.h"
#include "analyses/keys/keyed_balance.h"

namespace vibroimpact::analyses {

class BalanceTable : public BranchSink {
public:
  /// Keeps references.
  BalanceTable(const SweptParameter &parameter, KeyedBalance &system,
               continuation::HarmonicBalance &problem);

  void begin(long number, long /*halves*/, double sign) override { rows_.begin(number, sign); }
  void add(const continuation::BranchPoint &point) override {
    rows_.add_point(point, values_of(point));
  }
  void add(const continuation::SpecialPoint &special) override;
  void drop(long number) override { rows_.drop(number); }
  void end(const continuation::Branch &branch) override { rows_.end(branch); }

  void add_fields(const FieldWriter &result) const { rows_.add_fields(result, "balance_residual"); }

private:
  PointResult values_of(const continuation::BranchPoint &point) const;
  void add_points(const continuation::HarmonicMotion &motion, const continuation::LeftOut &left,
                  const FieldWriter &row) const;
  void add_contacts(const continuation::HarmonicMotion &motion, const FieldWriter &row) const;

  KeyedBalance &system_;
  continuation::HarmonicBalance &problem_;
  BranchRows rows_;
};

} // namespace vibroimpact::analyses
