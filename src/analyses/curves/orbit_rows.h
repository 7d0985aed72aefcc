// Rows of tables of periodic motions: what is known and recorded of each.
#pragma once

#include "analyses/keys/keyed_map.h"
#include "analyses/recorders/recorders.h"
#include "analyses/results/field_writer.h"
#include "periodic/orbit.h"

namespace vibroimpact::analyses {

/// The motion, and what the recorders see of one of its periods, or the reason why they fail.
/// `margin`: by which multipliers of a stable motion may exceed one. NumericalError.
PointResult orbit_row(const periodic::StroboscopicMap &map, const periodic::Orbit &orbit,
                      const System &system, motion::Trajectory &trajectory,
                      const std::vector<RecorderFactory> &recorders, double margin = 0);

class OrbitRows {
public:
  /// Keeps references.
  OrbitRows(KeyedMap &maps, const std::vector<RecorderFactory> &recorders)
      : maps_(maps), recorders_(recorders) {}

  /// orbit_row() at these keys.
  PointResult of(const Vector &keys, const periodic::Orbit &orbit) const;
  /// The same where the image is still to be computed.
  PointResult of(const Vector &keys, const periodic::Section &section, const Vector &state) const;

private:
  KeyedMap &maps_;
  const std::vector<RecorderFactory> &recorders_;
};

} // namespace vibroimpact::analyses
