#include "structure/director_kinematics.h"

#include <Eigen/Dense>

namespace vibroimpact::structure {

namespace {

Vector3 sum(const Eigen::Vector4d &weights, const NodeVectors &vectors) {
  Vector3 result = Vector3::Zero();
  for (int i = 0; i < 4; ++i)
    result += weights[i] * vectors[i];
  return result;
}

// 2 e_az = g_a . (sum h_i theta_i x V_i) + V . u,a
StrainRow shear(const DirectorPoint &point, const NodeVectors &directors, const Vector3 &tangent,
                const Eigen::Vector4d &derivative) {
  StrainRow row;
  for (int i = 0; i < 4; ++i) {
    row.segment<3>(6 * i) = derivative[i] * point.director;
    row.segment<3>(6 * i + 3) = point.rotation.value[i] * directors[i].cross(tangent);
  }
  return row;
}

} // namespace

DirectorPoint director_point(const Shape &translation, const Shape &rotation,
                             const NodeVectors &positions, const NodeVectors &directors) {
  return {.translation = translation,
          .rotation = rotation,
          .tangent_r = sum(translation.r, positions),
          .tangent_s = sum(translation.s, positions),
          .director = sum(translation.value, directors),
          .director_r = sum(translation.r, directors),
          .director_s = sum(translation.s, directors)};
}

StrainRow shear_r(const DirectorPoint &point, const NodeVectors &directors) {
  return shear(point, directors, point.tangent_r, point.translation.r);
}

StrainRow shear_s(const DirectorPoint &point, const NodeVectors &directors) {
  return shear(point, directors, point.tangent_s, point.translation.s);
}

// 2 k_ab = g_a . beta,b + g_b . beta,a + V,a . u,b + V,b . u,a with beta = sum h_i theta_i x V_i
Eigen::Matrix<double, 3, 24> covariant_curvature(const DirectorPoint &p,
                                                 const NodeVectors &directors) {
  Eigen::Matrix<double, 3, 24> rows;
  for (int i = 0; i < 4; ++i) {
    const Vector3 across_r = directors[i].cross(p.tangent_r);
    const Vector3 across_s = directors[i].cross(p.tangent_s);
    rows.block<1, 3>(0, 6 * i) = p.translation.r[i] * p.director_r;
    rows.block<1, 3>(1, 6 * i) = p.translation.s[i] * p.director_s;
    rows.block<1, 3>(2, 6 * i) =
        p.translation.s[i] * p.director_r + p.translation.r[i] * p.director_s;
    rows.block<1, 3>(0, 6 * i + 3) = p.rotation.r[i] * across_r;
    rows.block<1, 3>(1, 6 * i + 3) = p.rotation.s[i] * across_s;
    rows.block<1, 3>(2, 6 * i + 3) = p.rotation.s[i] * across_r + p.rotation.r[i] * across_s;
  }
  return rows;
}

TangentBasis::TangentBasis(const DirectorPoint &point) {
  const Vector3 normal = point.tangent_r.cross(point.tangent_s);
  area = normal.norm();
  first = point.tangent_r.normalized();
  second = normal.cross(first) / area;
  Eigen::Matrix2d components; // of the tangents, columns r and s
  components << point.tangent_r.dot(first), point.tangent_s.dot(first), point.tangent_r.dot(second),
      point.tangent_s.dot(second);
  const Eigen::Matrix2d t = components.inverse();
  shear = t.transpose();
  for (int row = 0; row < 2; ++row)
    in_plane.row(row) << t(0, row) * t(0, row), t(1, row) * t(1, row), t(0, row) * t(1, row);
  in_plane.row(2) << 2 * t(0, 0) * t(0, 1), 2 * t(1, 0) * t(1, 1),
      t(0, 0) * t(1, 1) + t(0, 1) * t(1, 0);
}

} // namespace vibroimpact::structure
