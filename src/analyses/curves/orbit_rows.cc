#include "analyses/curves/orbit_rows.h"

#include "analyses/curves/orbit_fields.h"
#include "analyses/results/fields.h"
#include "common/error.h"

namespace vibroimpact::analyses {

using periodic::Orbit;

PointResult orbit_row(const periodic::StroboscopicMap &map, const Orbit &orbit,
                      const System &system, motion::Trajectory &trajectory,
                      const std::vector<RecorderFactory> &recorders, double margin) {
  PointResult row;
  const Vector state = state_at_zero_phase(map, orbit);
  add_orbit(row, map, orbit, state, margin);
  try {
    record_orbit(row, recorders, system, map, orbit, state);
    add_accuracy(row, trajectory.accuracy(), system.integration);
  } catch (const NumericalError &error) {
    row.reason = error.what();
  }
  FieldWriter(row).number("recorded", row.reason.empty() ? 1 : 0, "1",
                          "0 where the recording of the motion failed and its values are "
                          "NaN; why stands in reason");
  return row;
}

PointResult OrbitRows::of(const Vector &keys, const Orbit &orbit) const {
  const periodic::StroboscopicMap &map = maps_.at(keys);
  return orbit_row(map, orbit, maps_.system(), maps_.trajectory(), recorders_);
}

PointResult OrbitRows::of(const Vector &keys, const periodic::Section &section,
                          const Vector &state) const {
  const periodic::StroboscopicMap &map = maps_.at(keys);
  Orbit orbit{.section = section, .point = {.state = state, .image = map.image(section, state)}};
  orbit.point.residual = map.norm(orbit.point.image.state - state) / map.norm(state);
  return of(keys, orbit);
}

} // namespace vibroimpact::analyses
