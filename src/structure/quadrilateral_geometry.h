// The bilinear surface through four corners, its mean plane, and the points of integration.
//
// With the corners' own coordinates r_i, s_i = -1 or 1,
//
//   x(r, s) = x_c + r x_r + s x_s + r s x_d,   x_r = sum r_i x_i / 4,   x_s = sum s_i x_i / 4,
//                                              x_d = sum r_i s_i x_i / 4,
//
// n = unit(x_r x x_s) is normal to the mean plane. x_d has components in it where the quadrilateral
// is no parallelogram, and one along n where it is warped.
#pragma once

#include "structure/director_kinematics.h"

namespace vibroimpact::structure {

inline constexpr std::array<double, 4> corner_r = {-1, 1, 1, -1};
inline constexpr std::array<double, 4> corner_s = {-1, -1, 1, 1};

Shape bilinear(double r, double s);

/// The 2 x 2 Gauss points, all of weight 1.
std::array<std::array<double, 2>, 4> gauss_points();

/// Unit normals of the bilinear surface at the corners, in the sense of the numbering.
NodeVectors corner_normals(const NodeVectors &corners);

/// Integral of each corner's bilinear function times the unit normal over the surface [m^2].
NodeVectors corner_areas(const NodeVectors &corners);

struct MeanPlane {
  explicit MeanPlane(const NodeVectors &corners);
  /// In-plane gradients of the bilinear functions of the nodes at a point [1/m].
  NodeVectors gradients(const DirectorPoint &point) const;

  Vector3 normal;
  Vector3 first; ///< unit vectors in the plane
  Vector3 second;
  Vector3 dual_r; ///< in the plane, dual_a . x_b is 1 for a = b and else 0 [1/m]
  Vector3 dual_s;
  double twist_r = 0; ///< components of x_d along x_r and x_s
  double twist_s = 0;
};

} // namespace vibroimpact::structure
