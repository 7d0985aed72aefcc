// How a periodic motion and what is recorded of it change with keys.
//
// The derivative of the state follows from the variational equations over one period P(x; p) = x of
// the motion, exactly and without any other motion:
//
//   x' = (1 - P_x)^-1 P_p
//
// Where the period T is free, P leads back to a plane with the normal n, and the motion x(T) there
// later by T' = -n . (x_x x' + x_p) / (n . dx/dt).
//
// and so do the derivatives of extreme values and impacts that recorders name (tangent_motion.h).
// For what has no closed form: motions that begin at x + x' d with the key at p + d stay within
// O(d^2) of the periodic motions there, so that what is recorded of them over one period has the
// same derivative by d as what is recorded of the periodic motions. It is taken from four such
// motions, some thousandths of the key apart, exactly to the fourth power of d. Stable and unstable
// motions are treated alike.
#pragma once

#include "analyses/curves/orbit_start.h"
#include "analyses/keys/swept_parameter.h"
#include "analyses/recorders/recorders.h"
#include "analyses/results/field_writer.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct OrbitKey {
  std::string name;         ///< of its section
  SweptParameter parameter; ///< with the present value alone; the frequency has none
};

/// The sections "Derivative".
void declare_orbit_keys(parameters::Section &section);
/// InputError for a key that holds no single number or belongs to an analysis.
std::vector<OrbitKey> read_orbit_keys(const parameters::Values &section);

/// The motion and how to record it.
struct RecordedOrbit {
  const System &system;
  periodic::StroboscopicMap &map;
  const periodic::Orbit &orbit;
  const std::vector<RecorderFactory> &recorders;
};

/// A system with the forcing of the motion, or where the period is free with this one [s].
periodic::ForcedSystem forced_like(const System &system, const RecordedOrbit &motion,
                                   double period);

/// Adds derivative/NAME/state, where the period is free derivative/NAME/period, and, for every
/// single number that the recorders give and that has a unit, derivative/NAME/FIELD. NumericalError
/// where the motion has no derivative, as at a fold.
void add_derivatives(const FieldWriter &result, const OrbitKey &key, const RecordedOrbit &motion,
                     const SystemSource &build);

} // namespace vibroimpact::analyses
