// What is kept of the loci of an analysis: their points, special points and ends, as arrays.
#pragma once

#include "analyses/curves/orbit_rows.h"
#include "analyses/results/curve_table.h"
#include "continuation/locus.h"

#include <optional>

namespace vibroimpact::analyses {

class LocusTable {
public:
  /// Keeps references. Motions are recorded over one of their periods.
  LocusTable(const std::vector<SweptParameter> &keys, KeyedMap &maps,
             const std::vector<RecorderFactory> &recorders);

  /// What follows is a part of locus `number`, whose motions are fixed points of maps over `halves`
  /// half periods. `sign`: -1 where the arclength falls.
  void begin(long number, continuation::LocusKind kind, long halves, double sign);
  void add(const continuation::LocusPoint &point);
  /// The part ends.
  void end(const continuation::Locus &locus);
  /// The locus cannot be entered at these keys.
  void end_at_start(const Vector &keys);

  /// Arrays, and why loci end early as the reason of the result.
  void add_fields(PointResult &result) const;

private:
  PointResult values_of(const continuation::LocusPoint &point) const;
  void add_end(const Vector &keys, double arclength, std::optional<continuation::End> end);
  periodic::Orbit orbit_of(const continuation::LocusPoint &point) const;

  KeyedMap &maps_;
  OrbitRows orbits_;
  CurveTable rows_;
  Label kind_; ///< of a locus
  continuation::LocusKind kind_number_ = continuation::LocusKind::fold;
  long halves_ = 2;
};

} // namespace vibroimpact::analyses
