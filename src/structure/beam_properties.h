// Stiffness and inertia of a beam at a place of its length: cross-section, material and theory put
// together.
#pragma once

#include "structure/cross_section.h"

#include <functional>

namespace vibroimpact::structure {

/// Per unit length; about the local axes y and z of the section.
struct BeamProperties {
  double axial_stiffness = 0;      ///< E A [N]
  double torsional_stiffness = 0;  ///< G J [N m^2]
  double bending_stiffness_y = 0;  ///< E I_y [N m^2]
  double bending_stiffness_z = 0;  ///< E I_z [N m^2]
  double mass_per_length = 0;      ///< [kg/m]
  double polar_inertia = 0;        ///< rho (I_y + I_z) [kg m]
  double shear_flexibility_y = 0;  ///< 1 / (kappa_y G A); 0 without shear deformation [1/N]
  double shear_flexibility_z = 0;  ///< 1 / (kappa_z G A) [1/N]
  double rotary_inertia_y = 0;     ///< rho I_y in bending; 0 in Euler-Bernoulli's theory [kg m]
  double rotary_inertia_z = 0;     ///< [kg m]
  double axial_force = 0;          ///< before any motion, tension positive [N]
  double polar_radius_squared = 0; ///< (I_y + I_z) / A [m^2]
};

/// Throws DefinitionError for a Young modulus or density out of range, and like shear_correction().
/// `shape` is uniform.
BeamProperties beam_properties(const SectionShape &shape, const Material &material);

/// Properties at a fraction 0 to 1 of the length of an element.
using PropertiesAlong = std::function<BeamProperties(double)>;

/// Properties of the part from `begin` to `end` (fractions of the length) of a beam, tapered or
/// not, under an axial force. Throws like beam_properties().
PropertiesAlong properties_along(const SectionShape &shape, const Material &material,
                                 const AxialForce &axial_force, double begin, double end);

} // namespace vibroimpact::structure
