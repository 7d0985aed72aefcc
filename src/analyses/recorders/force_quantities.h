// Forces that a model passes on: in its connections, and from each body to what it stands on.
#pragma once

#include "analyses/recorders/observables.h"

namespace vibroimpact::analyses {

/// connection/NAME/force: the tension k e + k3 e^3 + c e' [N], > 0 pulls the ends together. The
/// cube is taken as a quintic with its own value and first two derivatives at both ends of a step,
/// which is of the order of the dense output itself. bearing/NAME/first_force and second_force [N]
/// likewise.
std::vector<Observable> connection_forces(const model::Model &model);

/// body/NAME/base_force_x, _y, _z [N]: force of a body on its base along each axis on which a
/// motion of the base moves mass, through its own supports and the connections and bearings of its
/// points to the base or the ground. With B = base participation, m, c, k generalised mass, damping
/// and stiffness, M the total mass and a the acceleration of the base along an axis,
///
///   F = B^T m^-1 (k q + c q') - (M - B^T m^-1 B) a - sum of tensions n
///
/// The first part is what the springs, dashpots and clamps of the body carry; of a modal body it
/// converges with the number of modes for loads that are not distributed like the mass. The second
/// is the mass that the modes leave on the base.
std::vector<Observable> base_forces(const model::Model &model);

} // namespace vibroimpact::analyses
