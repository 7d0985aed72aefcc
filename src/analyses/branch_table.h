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
  /// A branch that begins at this value of the key is not followed.
  void note_missing(double key, const std::string &why);
  /// The part ends.
  void end(const continuation::Branch &branch);

  /// Arrays, and why something failed as the reason of the result.
  void add_fields(PointResult &result) const;

private:
  PointResult orbit_of(const continuation::BranchPoint &point);
  std::string at(double key) const;
  void record(const Vector &state, double period, long periods, PointResult &row) const;

  const SweptParameter &parameter_;
  KeyedMap &maps_;
  const std::vector<RecorderFactory> &recorders_;
  BranchRows rows_;
  std::vector<std::string> remarks_; ///< why something failed
  long halves_ = 2;
  double sign_ = 1;
};

} // namespace vibroimpact::analyses
