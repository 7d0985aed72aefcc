// Connections: springs and dashpots between two points of any bodies, or a point and its base.
//
//   tension = k e + k3 e^3 + c e'     e   elongation (u_b - u_a) . n [m], e' its rate
//                                     k   stiffness [N/m], k3 cubic stiffness [N/m^3]
//                                     c   damping constant [N s/m]
//
// About an axis (Direction = rx and so on) e is a relative rotation [rad], the tension a torque [N
// m]. A positive tension pulls the two points together. Stored energy k e^2/2 + k3 e^4/4,
// dissipated power c e'^2. Ground may move with the base motions that name the connection: supports
// with motions of their own.
#pragma once

#include "model/side.h"
#include "parameters/values.h"

namespace vibroimpact::model {

/// Declares the kind "Connection".
void declare_connections(parameters::Section &root);

/// Is it one between a point and ground, along a direction? For sections not yet checked.
bool joins_ground(const parameters::Values &connection);

/// (u_b - u_a) . n of the connection called `name`, with the motions of its ground.
Projection connection_elongation(const parameters::Values &root, const std::string &name,
                                 const Sides &sides, const MotionAxis &axis, const Model &model);

/// Adds all connections of the file to the model; its sources must be complete. InputError for
/// unknown points, a direction along which nothing moves, and a connection without any constant.
void add_connections(const parameters::Values &root, Model &model);

} // namespace vibroimpact::model
