// What is kept of the branches of an analysis: their points, special points and ends, as arrays.
#pragma once

#include "analyses/branch_rows.h"
#include "analyses/keyed_map.h"
#include "analyses/recorders.h"

namespace vibroimpact::analyses {

class BranchTable {
public:
  /// Keeps references. Motions are recorded over one of their periods.
  BranchTable(const SweptParameter &parameter, KeyedMap &maps,
              const std::vector<RecorderFactory> &recorders);

  /// Records what follow() finds from here on: a part of branch `number` whose motions are fixed
  /// points of maps over `halves` half periods. `sign`: -1 where the arclength falls.
  void begin(long number, long halves, double sign);
  void add(const continuation::BranchPoint &point);
  void add(const continuation::SpecialPoint &special);
  /// Forgets all of a branch.
  void drop(long number) { rows_.drop(number); }
  /// The part ends.
  void end(const continuation::Branch &branch) { rows_.end(branch); }

  std::size_t size() const { return rows_.size(); }
  void add_fields(PointResult &result) const { rows_.add_fields(result, "orbit_residual"); }

private:
  PointResult orbit_of(const continuation::BranchPoint &point) const;
  void record(const Vector &state, double period, long periods, PointResult &row) const;

  const SweptParameter &parameter_;
  KeyedMap &maps_;
  const std::vector<RecorderFactory> &recorders_;
  BranchRows rows_;
  long halves_ = 2;
  double sign_ = 1;
};

} // namespace vibroimpact::analyses
