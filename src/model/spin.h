// Bodies that turn about their Spin axis at a given speed Omega(t):
//
//   M q'' + (C + Omega G) q' + (K + Omega N + Omega^2 K_c) q = f
//
// G is skew: gyroscopic moments in the fixed frame, Coriolis forces in the rotating one, where
// centrifugal forces bring K_c besides. A constant speed makes them parts of the damping and
// stiffness matrices; along a ramp these forces change in time. N is skew too: circulatory forces
// of the damping that turns with the body; what turns the shaft puts their work in. The torque that
// changes the speed acts along the axis of each section, so that it brings no moment across.
#pragma once

#include "model/spin_speed.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::model {

class Model;

struct Spin {
  std::string name;
  SpinSpeed speed;
  std::vector<std::size_t> bodies; ///< positions in the model
};

/// Declares the kind "Spin".
void declare_spins(parameters::Section &root);
/// Adds all spins of the file whose bodies are in the model. InputError for unknown bodies, those
/// without a Spin axis, and those of two spins.
void add_spins(const parameters::Values &root, Model &model);
/// The speed of the section that `key` names, and the position of the first of its bodies.
/// InputError.
Spin read_spin(const parameters::Values &root, const parameters::Values &section,
               const std::string &key, const Model &model);

} // namespace vibroimpact::model
