// What is kept of the loci of an analysis: their points, special points and ends, as arrays.
#pragma once

#include "analyses/curve_rows.h"
#include "analyses/field_writer.h"
#include "analyses/kept_rows.h"
#include "analyses/orbit_rows.h"
#include "continuation/locus.h"

#include <optional>

namespace vibroimpact::analyses {

class LocusTable {
public:
  /// Keeps references. Motions are recorded over one of their periods; rows are steps of the
  /// record, if there is one.
  LocusTable(const std::vector<SweptParameter> &keys, KeyedMap &maps,
             const std::vector<RecorderFactory> &recorders, StepRecord *steps);

  /// What follows is a part of locus `number`, whose motions are fixed points of maps over `halves`
  /// half periods. `sign`: -1 where the arclength falls.
  void begin(long number, continuation::LocusKind kind, long halves, double sign);
  void add(const continuation::LocusPoint &point);
  /// The part ends.
  void end(const continuation::Locus &locus);
  /// The locus cannot be entered at these keys.
  void end_at_start(const Vector &keys);

  void add_fields(const FieldWriter &result) const;

private:
  CurveRow row_of(const continuation::LocusPoint &point);
  PointResult values_of(const continuation::LocusPoint &point) const;
  void add_end(const Vector &keys, double arclength, std::optional<continuation::LocusEnd> end);
  void add_keys(const FieldWriter &row, const Vector &keys) const;
  periodic::Orbit orbit_of(const continuation::LocusPoint &point) const;

  KeyedMap &maps_;
  OrbitRows orbits_;
  KeptRows kept_;
  std::vector<Label> keys_;
  Label arclength_, locus_, kind_;
  long number_ = 0;
  continuation::LocusKind kind_number_ = continuation::LocusKind::fold;
  long halves_ = 2;
  double sign_ = 1;
  std::vector<CurveRow> points_, special_, ends_;
};

} // namespace vibroimpact::analyses
