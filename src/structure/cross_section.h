// Area, second moments and torsion constant of a cross-section, and what they make of a material.
#pragma once

#include "structure/beam_definition.h"

namespace vibroimpact::structure {

struct CrossSection {
  double area = 0;             ///< [m^2]
  double second_moment_y = 0;  ///< integral of z^2, bending in the local x-z plane [m^4]
  double second_moment_z = 0;  ///< integral of y^2, bending in the local x-y plane [m^4]
  double torsion_constant = 0; ///< St Venant [m^4]
};

/// Throws DefinitionError for dimensions that are missing, not positive or impossible.
CrossSection cross_section(const SectionShape &shape);

/// A place of the cross-section where the stress may be largest: direct stress by axial force and
/// bending moments, shear stress by torque. (Shear by transverse forces vanishes there or is
/// small.)
struct Fibre {
  double by_axial_force = 0; ///< [1/m^2]
  double by_moment_y = 0;    ///< about the local y axis [1/m^3]
  double by_moment_z = 0;    ///< [1/m^3]
  double by_torque = 0;      ///< [1/m^3]
};

/// Corners and middles of the sides of a rectangle, 32 places around a circle or tube; none of a
/// section that is given by its constants. Throws DefinitionError like cross_section().
std::vector<Fibre> extreme_fibres(const SectionShape &shape);

/// Places around a cross-section, y and z of its local axes [m]: the corners of a rectangle, twelve
/// places around a circle or tube, and for a section given by its constants the corners of the
/// rectangle with the same radii of gyration. Throws DefinitionError like cross_section().
std::vector<Eigen::Vector2d> section_outline(const SectionShape &shape);

/// What an element asks of its cross-section beyond stiffness and inertia.
struct SectionPlaces {
  std::vector<Fibre> fibres; ///< where its stress is looked at
  std::vector<Eigen::Vector2d> outline;
};

/// Stiffness and inertia of a beam per unit length.
struct BeamProperties {
  double axial_stiffness = 0;     ///< E A [N]
  double torsional_stiffness = 0; ///< G J [N m^2]
  double bending_stiffness_y = 0; ///< E I_y [N m^2]
  double bending_stiffness_z = 0; ///< E I_z [N m^2]
  double mass_per_length = 0;     ///< [kg/m]
  double polar_inertia = 0;       ///< rho (I_y + I_z) [kg m]
};

/// Throws DefinitionError for a Young modulus or density out of range.
BeamProperties beam_properties(const CrossSection &section, const Material &material);

} // namespace vibroimpact::structure
