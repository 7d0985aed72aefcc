// What is kept of the branches of an analysis: their points, special points and ends, as arrays.
#pragma once

#include "analyses/keyed_map.h"
#include "analyses/recorders.h"
#include "continuation/branch.h"

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
  void drop(long number);
  /// The part ends.
  void end(const continuation::Branch &branch);

  std::size_t size() const { return points_.size(); }
  void add_fields(PointResult &result) const;

private:
  struct Row {
    double arclength = 0;
    long branch = 0;
    PointResult values{};
  };
  PointResult orbit_of(const continuation::BranchPoint &point) const;
  void record(const Vector &state, double period, long periods, PointResult &row) const;
  Row row_of(const continuation::BranchPoint &point) const;
  static std::vector<PointResult> in_order(std::vector<Row> rows);

  const SweptParameter &parameter_;
  KeyedMap &maps_;
  const std::vector<RecorderFactory> &recorders_;
  Label key_, arclength_, branch_;
  long number_ = 0;
  long halves_ = 2;
  double sign_ = 1;
  std::vector<Row> points_, special_, ends_;
};

} // namespace vibroimpact::analyses
