// What turning at a speed adds to a straight beam, per unit of the speed or its square.
//
// In the fixed frame: a section that turns at Omega about the axis a has the angular momentum
// rho I_p Omega e along its own axis, which tilts with it, e = a + theta x a. Its rate is a moment
// against the motion,
//
//   rho I_p Omega (theta' x a),
//
// the gyroscopic moment (nelson1976). In the rotating frame mass at y + u from the axis has the
// velocity u' + Omega a x (y + u): Coriolis forces 2 Omega a x u', and centrifugal ones
// Omega^2 (y + u) across the axis, which pull members along the radius straight (rotating_beam).
//
// Internal damping of a material, stress E (strain + tau strain'), sees the strain rate of the
// turning section. With R u = a x u, of rotations likewise, that of the frame is u' - Omega R u, so
// that an element with the stiffness K has the forces
//
//   -tau K u' + Omega tau K R u
//
// the second of which, circulatory forces, can take work from what turns the shaft (genta2005). For
// a section that is equally stiff in all directions K R is skew.
#pragma once

#include "structure/beam_matrices.h"

namespace vibroimpact::structure {

/// Rows and columns as of BeamMatrices, local axes.
struct BeamSpin {
  ElementMatrix gyroscopic = ElementMatrix::Zero();  ///< skew: forces -Omega G u'
  ElementMatrix turning = ElementMatrix::Zero();     ///< skew: v . (a x u) over the mass
  ElementMatrix crosswise = ElementMatrix::Zero();   ///< symmetric: |a x u|^2 over the mass
  ElementMatrix stiffness = ElementMatrix::Zero();   ///< K, of bending, shear, twist and stretch
  ElementMatrix circulatory = ElementMatrix::Zero(); ///< of the fixed frame: -K R
  /// Of the rotating frame: symmetric, forces -Omega^2 K u of the motion in the field of
  /// centrifugal forces; and Omega^2 times the load, at rest.
  ElementMatrix centrifugal = ElementMatrix::Zero();
  ElementVector load = ElementVector::Zero();
};

/// Where an element is in the frame of its axis, in its local axes.
struct SpinPlace {
  Vector3 axis;                    ///< unit vector
  Vector3 start = Vector3::Zero(); ///< first end, from a place of the axis [m]
};

BeamSpin beam_spin(const PropertiesAlong &properties, double length, const Releases &releases,
                   const SpinPlace &place);
/// In the rotating frame. Sections are rigid and have the inertia of their theory.
BeamSpin rotating_beam(const PropertiesAlong &properties, double length, const Releases &releases,
                       const SpinPlace &place);
/// Geometric stiffness, per square of the speed, of the axial force that belongs to a displacement
/// of the ends under the centrifugal load at unit speed: its mean follows from the stretch, its
/// course along the element from the load there.
ElementMatrix centrifugal_stiffening(const PropertiesAlong &properties, double length,
                                     const Releases &releases, const SpinPlace &place,
                                     const ElementVector &displacement);

/// The matrix of the cross product, w x u = cross_matrix(w) u.
Eigen::Matrix3d cross_matrix(const Vector3 &w);

/// A rigid piece with the second moments P = integral of s s^T about its centre, whose rotation is
/// R = 1 + Theta + Theta^2 / 2: what half the square of d(R s)/dt + Omega a x R s has of second
/// order in theta, and of first order.
struct TurningPiece {
  Eigen::Matrix3d gyroscopic;  ///< skew
  Eigen::Matrix3d centrifugal; ///< symmetric
  Vector3 load;
};
TurningPiece turning_piece(const Eigen::Matrix3d &second_moments, const Vector3 &axis);

} // namespace vibroimpact::structure
