// Connections: springs and dashpots between two points of any bodies, or a point and its base.
//
//   tension = k e + k3 e^3 + c e'     e   elongation (u_b - u_a) . n [m], e' its rate
//                                     k   stiffness [N/m], k3 cubic stiffness [N/m^3]
//                                     c   damping constant [N s/m]
//
// About an axis (Direction = rx and so on) e is a relative rotation [rad], the tension a torque [N
// m]. A positive tension pulls the two points together. Stored energy k e^2/2 + k3 e^4/4,
// dissipated power c e'^2.
#pragma once

#include "model/model.h"
#include "parameters/values.h"

namespace vibroimpact::model {

/// Declares the kind "Connection".
void declare_connections(parameters::Section &root);

/// Adds all connections of the file to the model; its sources must be complete. InputError for
/// unknown points, a direction along which nothing moves, and a connection without any constant.
void add_connections(const parameters::Values &root, Model &model);

} // namespace vibroimpact::model
