#include "structure/quadrilateral_geometry.h"

#include <Eigen/Geometry>

#include <cmath>

namespace vibroimpact::structure {

Shape bilinear(double r, double s) {
  Shape shape;
  for (int i = 0; i < 4; ++i) {
    const double along_r = 1 + corner_r[i] * r;
    const double along_s = 1 + corner_s[i] * s;
    shape.value[i] = along_r * along_s / 4;
    shape.r[i] = corner_r[i] * along_s / 4;
    shape.s[i] = corner_s[i] * along_r / 4;
  }
  return shape;
}

std::array<std::array<double, 2>, 4> gauss_points() {
  const double g = 1 / std::sqrt(3.0);
  return {{{-g, -g}, {g, -g}, {g, g}, {-g, g}}};
}

NodeVectors corner_normals(const NodeVectors &corners) {
  NodeVectors normals;
  for (int i = 0; i < 4; ++i)
    normals[i] =
        (corners[(i + 1) % 4] - corners[i]).cross(corners[(i + 3) % 4] - corners[i]).normalized();
  return normals;
}

NodeVectors corner_areas(const NodeVectors &corners) {
  NodeVectors areas;
  areas.fill(Vector3::Zero());
  for (const auto &[r, s] : gauss_points()) {
    const Shape shape = bilinear(r, s);
    Vector3 tangent_r = Vector3::Zero();
    Vector3 tangent_s = Vector3::Zero();
    for (int i = 0; i < 4; ++i) {
      tangent_r += shape.r[i] * corners[i];
      tangent_s += shape.s[i] * corners[i];
    }
    for (int i = 0; i < 4; ++i)
      areas[i] += shape.value[i] * tangent_r.cross(tangent_s);
  }
  return areas;
}

MeanPlane::MeanPlane(const NodeVectors &corners) {
  Vector3 x_r = Vector3::Zero();
  Vector3 x_s = Vector3::Zero();
  Vector3 x_d = Vector3::Zero();
  for (int i = 0; i < 4; ++i) {
    x_r += corner_r[i] / 4 * corners[i];
    x_s += corner_s[i] / 4 * corners[i];
    x_d += corner_r[i] * corner_s[i] / 4 * corners[i];
  }
  const Vector3 product = x_r.cross(x_s);
  normal = product.normalized();
  first = x_r.normalized();
  second = normal.cross(first);
  dual_r = x_s.cross(normal) / product.norm();
  dual_s = normal.cross(x_r) / product.norm();
  twist_r = dual_r.dot(x_d);
  twist_s = dual_s.dot(x_d);
}

// The duals of the tangents as seen along the normal.
NodeVectors MeanPlane::gradients(const DirectorPoint &point) const {
  const double area = normal.dot(point.tangent_r.cross(point.tangent_s));
  const Vector3 along_r = point.tangent_s.cross(normal) / area;
  const Vector3 along_s = normal.cross(point.tangent_r) / area;
  NodeVectors gradients;
  for (int i = 0; i < 4; ++i)
    gradients[i] = point.translation.r[i] * along_r + point.translation.s[i] * along_s;
  return gradients;
}

} // namespace vibroimpact::structure
