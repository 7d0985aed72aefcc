// Bending and transverse shear of a shell whose material normals (directors) stay straight: the
// rotation of the director V is theta x V, and the part of the displacement gradient that is linear
// in the thickness coordinate bends the shell. Written in covariant components with respect to the
// element's own coordinates r, s, in which the assumed shear fields of the MITC elements are given
// (dvorkin1984). A rigid motion, theta = omega and u = omega x position, strains nothing, whatever
// the shape of the element.
#pragma once

#include "structure/element.h"

#include <Eigen/Core>

#include <array>

namespace vibroimpact::structure {

/// One function of each of up to four nodes at a point: value, d/dr and d/ds.
struct Shape {
  Eigen::Vector4d value = Eigen::Vector4d::Zero();
  Eigen::Vector4d r = Eigen::Vector4d::Zero();
  Eigen::Vector4d s = Eigen::Vector4d::Zero();
};

using NodeVectors = std::array<Vector3, 4>;
/// Columns 6 i + component of node i.
using StrainRow = Eigen::Matrix<double, 1, 24>;

/// Everything that is needed at one point (r, s).
struct DirectorPoint {
  Shape translation; ///< interpolates positions, displacements and directors
  Shape rotation;    ///< interpolates the rotations of the directors
  Vector3 tangent_r; ///< of the mid-surface
  Vector3 tangent_s;
  Vector3 director; ///< interpolated
  Vector3 director_r;
  Vector3 director_s;
};

DirectorPoint director_point(const Shape &translation, const Shape &rotation,
                             const NodeVectors &positions, const NodeVectors &directors);

/// Twice the covariant shear strains, 2 e_rz and 2 e_sz.
StrainRow shear_r(const DirectorPoint &point, const NodeVectors &directors);
StrainRow shear_s(const DirectorPoint &point, const NodeVectors &directors);

/// Covariant curvatures k_rr, k_ss, 2 k_rs.
Eigen::Matrix<double, 3, 24> covariant_curvature(const DirectorPoint &point,
                                                 const NodeVectors &directors);

/// From covariant components to those in a Cartesian basis of the tangent plane.
struct TangentBasis {
  explicit TangentBasis(const DirectorPoint &point);
  Eigen::Matrix3d in_plane; ///< (e_11, e_22, 2 e_12) from (e_rr, e_ss, 2 e_rs)
  Eigen::Matrix2d shear;    ///< from (2 e_rz, 2 e_sz)
  double area = 0;          ///< of the surface per dr ds
  Vector3 first;            ///< unit vectors of the basis
  Vector3 second;
};

} // namespace vibroimpact::structure
