// Area, second moments, torsion constant and shear correction of a cross-section.
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

/// Whether a dimension changes along the beam.
bool tapered(const SectionShape &shape);

/// The dimensions at the fraction `along` of the length of a tapered beam, as those of a uniform
/// one.
SectionShape shape_at(const SectionShape &shape, double along);

/// Factors of the area that carry the shear forces along local y and z in Timoshenko's theory:
/// those that are given, or Cowper's for the shape and Poisson's ratio. Throws DefinitionError for
/// a section that is given by its constants without them.
std::array<double, 2> shear_correction(const SectionShape &shape, double poisson_ratio);

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

} // namespace vibroimpact::structure
