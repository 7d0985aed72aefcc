// The matrices of a straight beam between its two ends, in its local axes, from the flexibility of
// what lies between: exact for forces at the ends, however the section changes along it.
#pragma once

#include "structure/beam_properties.h"

#include <Eigen/Dense>

#include <utility>
#include <vector>

namespace vibroimpact::structure {

/// Rows u, v, w, rx, ry, rz of the first end, then of the second.
using ElementVector = Eigen::Matrix<double, 12, 1>;
using ElementMatrix = Eigen::Matrix<double, 12, 12>;
/// Of the six deformations: stretch, twist, the end rotations about y relative to the chord (first
/// end, second end), those about z.
using DeformationVector = Eigen::Matrix<double, 6, 1>;
using DeformationMatrix = Eigen::Matrix<double, 6, 6>;

/// Which displacements and rotations of both ends are not passed on to the nodes, in the rows of an
/// ElementVector: a hinge is a rotation of one end.
using Releases = std::array<bool, 12>;

/// All symmetric.
struct BeamMatrices {
  DeformationMatrix stiffness; ///< forces that belong to the deformations; none at releases
  ElementMatrix mass;          ///< consistent with the deflection under forces at the ends
  ElementMatrix geometric;     ///< of the axial force
  /// Motion of the beam's own ends from that of the nodes: they differ at releases.
  ElementMatrix ends;
  double total_mass = 0; ///< [kg]
};

/// Motion u, v, w, rx, ry, rz of a section from that of both ends.
using SectionMotion = Eigen::Matrix<double, 6, 12>;
using EndRow = Eigen::Matrix<double, 1, 12>;

/// One plane of bending at a section: slope of the axis v' = r + g, rotation r, its change r' along
/// the beam, shear angle g and shear force.
struct Bending {
  EndRow slope, rotation, curvature, shear_angle, shear_force;
};

/// A section at a point of the rule of integration, without releases.
struct SectionSample {
  double along = 0; ///< fraction of the length
  double part = 0;  ///< of the length that it stands for [m]
  BeamProperties properties{};
  SectionMotion motion{};
  Bending xy{}, xz{}; ///< the rotation of the second, whose slope is w', is -ry
  EndRow twist{};     ///< rx' [1/m]
};

/// Points (fractions) and weights of the rule of integration along an element.
const std::vector<std::pair<double, double>> &line_gauss_points();

/// `stiffness`: of the deformations.
std::vector<SectionSample> section_samples(const PropertiesAlong &properties, double length,
                                           const DeformationMatrix &stiffness);

/// Work of an axial force N over the lengthening by slopes and twist, per length,
///   N (v'^2 + w'^2 + (I_y + I_z) / A rx'^2) / 2.
ElementMatrix axial_work(const SectionSample &sample, double axial_force);

/// Forces that belong to the deformations, without releases.
DeformationMatrix deformation_stiffness(const PropertiesAlong &properties, double length);

/// 6 x 12, deformations from the motion of both ends.
Eigen::Matrix<double, 6, 12> deformation_matrix(double length);

/// `length` > 0 [m]. Throws NumericalError when the releases leave the beam loose in itself.
BeamMatrices beam_matrices(const PropertiesAlong &properties, double length,
                           const Releases &releases);

} // namespace vibroimpact::structure
