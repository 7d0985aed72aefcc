// Fields of periodic motions that several analyses share.
#pragma once

#include "analyses/recorders/recorders.h"
#include "analyses/results/field_writer.h"
#include "periodic/orbit.h"

#include <optional>

namespace vibroimpact::analyses {

/// Multipliers, stability, residual, multiple, symmetry and section of an orbit, and its state at
/// phase 0. Multipliers of a stable motion are below 1 + `margin`: without losses some are 1 but
/// for rounding.
void add_orbit(const FieldWriter &result, const periodic::StroboscopicMap &map,
               const periodic::Orbit &orbit, const Vector &state_at_zero, double margin = 0);

/// Adds what the recorders see of the motion until it repeats itself. They begin at phase 0, or,
/// where a contact is closed there, in the middle of the longest stay without one, so that no
/// impact is cut in two; where one is always closed, at the section. Returns the motion from a
/// phase from which all of this has the same values and derivatives, away from contact changes.
/// NumericalError.
periodic::Orbit record_orbit(const FieldWriter &result,
                             const std::vector<RecorderFactory> &recorders, const System &system,
                             const periodic::StroboscopicMap &map, const periodic::Orbit &orbit,
                             const Vector &state_at_zero);

/// After how many periods the settled motion repeated itself from which the orbit was found: 0, it
/// was not seen to; none, nothing settled. An unstable orbit is not where such a motion settles.
void add_settled_multiple(PointResult &result, std::optional<long> multiple);
/// The orbit is unstable, though it was found from a motion that had settled, to something else.
bool settled_elsewhere(const PointResult &result);

} // namespace vibroimpact::analyses
