// Shell bodies that several tests use.
#pragma once

#include "structure/body_model.h"

#include <cmath>

namespace vibroimpact::examples {

using structure::CellShape;
using structure::Load;
using structure::Location;
using structure::ShellDefinition;

inline constexpr std::array<bool, 6> hold_all = {true, true, true, true, true, true};

/// Square plate of NAFEMS FV12: 10 m, 50 mm thick, in the x-y plane.
inline ShellDefinition square_plate(int elements, CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell;
  shell.plate = structure::Plate{.corner = {0, 0, 0},
                                 .first_end = {10, 0, 0},
                                 .second_end = {0, 10, 0},
                                 .elements = {elements, elements},
                                 .shape = shape};
  shell.parts.push_back({"plate", "all", 0.05, {200e9, 0.3, 8000}});
  return shell;
}

/// Only bending: no motion in the plane, no drilling.
inline void hold_in_plane(ShellDefinition &shell) {
  shell.supports.push_back({"plane", {"all", {}}, {true, true, false, false, false, true}, {}});
}

/// Thin plate of area a^2: sqrt(D / (rho t)) / a^2 [rad/s], the scale of its frequencies.
inline double plate_frequency_scale(const ShellDefinition &shell) {
  const structure::MeshPart &part = shell.parts[0];
  const double side = (shell.plate->first_end - shell.plate->corner).norm();
  const double nu = part.material.poisson_ratio;
  const double bending =
      part.material.young_modulus * std::pow(part.thickness, 3) / (12 * (1 - nu * nu));
  return std::sqrt(bending / (part.material.density * part.thickness)) / (side * side);
}

/// A force [N] at a group of nodes or at a position.
inline Load force_at(const std::string &name, const Location &at, const Vector3 &force) {
  Load load;
  load.name = name;
  load.at = at;
  load.force = force;
  return load;
}

/// The weight of all mass under an acceleration [m/s^2].
inline Load weight(const Vector3 &acceleration) {
  Load load;
  load.name = "weight";
  load.acceleration = acceleration;
  return load;
}

/// A pressure [Pa] on all surfaces.
inline Load pressure(double value) {
  Load load;
  load.name = "wind";
  load.pressure = value;
  return load;
}

} // namespace vibroimpact::examples
