// What is kept of the branches of an analysis: their points, special points and ends, as arrays.
#pragma once

#include "analyses/curves/branch_follower.h"
#include "analyses/curves/branch_rows.h"
#include "analyses/results/field_writer.h"

#include <functional>

namespace vibroimpact::analyses {

class BranchTable : public BranchSink {
public:
  /// What is known of the motion of a point, a fixed point of a map over so many half periods; with
  /// the reason where its recording fails.
  using RowOf = std::function<PointResult(const continuation::BranchPoint &point, long halves)>;
  BranchTable(const Label &key, RowOf row_of);

  void begin(long number, long halves, double sign) override;
  void add(const continuation::BranchPoint &point) override;
  void add(const continuation::SpecialPoint &special) override;
  /// Where the frequency of motions turns whose key is another one.
  void add_frequency_fold(const continuation::BranchPoint &at);
  void drop(long number) override { rows_.drop(number); }
  void note_missing(double key, const std::string &why) override;
  void end(const continuation::Branch &branch) override;

  /// Arrays, and why something failed as the reason of the result.
  void add_fields(PointResult &result) const;

  /// A branch ends at its start, by its least step.
  bool stuck() const { return stuck_; }

private:
  PointResult orbit_of(const continuation::BranchPoint &point);
  void note_enclosed(const continuation::SpecialPoint &special);
  void note_sliding(const continuation::SpecialPoint &special);

  Label key_;
  RowOf row_of_;
  BranchRows rows_;
  long halves_ = 2;
  double sign_ = 1;
  bool stuck_ = false;
};

} // namespace vibroimpact::analyses
