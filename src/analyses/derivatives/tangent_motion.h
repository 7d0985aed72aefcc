// Derivatives by a key of what is recorded of one period of a periodic motion, from the variational
// equations alone: each recorder says which it has.
#pragma once

#include "analyses/derivatives/extreme_tangents.h"
#include "analyses/derivatives/impact_tangents.h"
#include "analyses/derivatives/orbit_derivatives.h"

namespace vibroimpact::analyses {

/// What recorders make their derivatives of.
struct TangentMotion {
  const ExtremeTangents &extremes; ///< of the extrema that they have named
  const ImpactTangents &impacts;
};

/// Single numbers under the names of the recorders' fields, per unit of the key. What has no closed
/// form is left out: all where the key moves breaks of the excitation, forces that hold a gap in
/// phases that are not linear, and what other recorders give. `by_key`: derivative of the state at
/// the section, at fixed phase.
PointResult measure_tangents(const RecordedOrbit &motion, periodic::ForcedKey &key,
                             const std::vector<motion::KeyNeighbour> &neighbours,
                             const Vector &by_key);

} // namespace vibroimpact::analyses
