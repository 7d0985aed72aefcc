// The matrices of a straight beam between its two ends, in its local axes, from the flexibility of
// what lies between: exact for forces at the ends, however the section changes along it.
#pragma once

#include "structure/beam_properties.h"

#include <Eigen/Dense>

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

/// 6 x 12, deformations from the motion of both ends.
Eigen::Matrix<double, 6, 12> deformation_matrix(double length);

/// `length` > 0 [m]. Throws NumericalError when the releases leave the beam loose in itself.
BeamMatrices beam_matrices(const PropertiesAlong &properties, double length,
                           const Releases &releases);

} // namespace vibroimpact::structure
