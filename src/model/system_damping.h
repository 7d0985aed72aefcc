// Damping of the modes of the whole system: all bodies with their connections, contacts open.
//
//   C = sum over modes j of d_j (M phi_j)(M phi_j)^T,   phi_j^T M phi_j = 1
//
// with d_j = 2 zeta_j omega_j, or alpha + beta omega_j^2, which makes C = alpha M + beta K. It acts
// on the motion relative to the place where the system would rest with its bases as they are, so
// that a slow motion of a base brings no force: the coordinate of a mode counts from
// phi_j^T f s / omega_j^2 with f the load of a base motion s.
//
// Modal damping: [clough1975], damping matrices from modal ratios.
#pragma once

#include "model/model.h"
#include "parameters/section.h"
#include "parameters/values.h"

namespace vibroimpact::model {

void declare_system_damping(parameters::Section &root);
/// After all connections. InputError where the system has rotors, which have no modes.
void add_system_damping(const parameters::Values &root, Model &model);

} // namespace vibroimpact::model
