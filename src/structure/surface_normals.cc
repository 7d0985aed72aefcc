#include "structure/surface_normals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace vibroimpact::structure {

namespace {

const double fold = std::cos(M_PI / 6);

struct CornerNormal {
  Vector3 direction;
  double angle = 0; ///< of the surface at this corner [rad]
};

CornerNormal corner_normal(const Mesh &mesh, const Cell &surface, int corner) {
  const auto nodes = surface.nodes();
  const Vector3 &here = mesh.nodes[nodes[corner]];
  const Vector3 next = mesh.nodes[nodes[(corner + 1) % surface.size]] - here;
  const Vector3 last = mesh.nodes[nodes[(corner + surface.size - 1) % surface.size]] - here;
  const Vector3 product = next.cross(last);
  return {product.normalized(), std::atan2(product.norm(), next.dot(last))};
}

/// Neighbours may be numbered the other way round.
Vector3 mean_normal(const CornerNormal &own, const std::vector<CornerNormal> &around) {
  Vector3 sum = Vector3::Zero();
  for (const CornerNormal &other : around) {
    const double alignment = other.direction.dot(own.direction);
    if (std::abs(alignment) >= fold)
      sum += std::copysign(other.angle, alignment) * other.direction;
  }
  return sum.normalized();
}

} // namespace

std::vector<std::array<Vector3, 4>> surface_normals(const Mesh &mesh) {
  std::vector<std::vector<CornerNormal>> around(mesh.nodes.size());
  for (const Cell &surface : mesh.cells)
    for (int i = 0; i < surface.size; ++i)
      around[surface.corners[i]].push_back(corner_normal(mesh, surface, i));
  std::vector<std::array<Vector3, 4>> normals;
  for (const Cell &surface : mesh.cells) {
    auto &own = normals.emplace_back();
    own.fill(Vector3::Zero());
    for (int i = 0; i < surface.size; ++i)
      own[i] = mean_normal(corner_normal(mesh, surface, i), around[surface.corners[i]]);
  }
  return normals;
}

double sagitta(std::span<const Vector3> corners, std::span<const Vector3> normals,
               const Vector3 &own) {
  double largest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    largest = std::max(largest, (normals[i] - own).norm() * corners[i].norm() / 2);
  return largest;
}

} // namespace vibroimpact::structure
