// Initial conditions of the parameter file: displacements and velocities of the coordinates.
#pragma once

#include "model/model.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::model {

struct InitialState {
  Vector displacement; ///< n
  Vector velocity;     ///< n
};

void declare_initial_conditions(parameters::Section &root);

/// The sum of the initial conditions called `names` (instances of "Initial condition").
InitialState read_initial_state(const parameters::Values &root,
                                const std::vector<std::string> &names, const Model &model);

/// In which equilibrium a motion starts, before displacements and velocities are added.
enum class EquilibriumStart { none, with_contacts, without_contacts };
EquilibriumStart equilibrium_start(const parameters::Values &root,
                                   const std::vector<std::string> &names);

/// Coordinates of a body in the static shape of a point force that moves the point by
/// `displacement` along an axis, or of a torque that turns it about one:
/// q_j proportional to phi_j / k_j; where a single coordinate moves the point, that one.
/// NumericalError when the body is free to move as a rigid body or the force does not move the
/// point.
Vector static_deflection(const reduction::ReducedBody &body, const reduction::BodyPoint &point,
                         const MotionAxis &axis, double displacement);

} // namespace vibroimpact::model
