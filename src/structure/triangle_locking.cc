#include "structure/triangle_locking.h"

#include <Eigen/Geometry>

#include <cmath>
#include <sstream>

namespace vibroimpact::structure {

namespace {

constexpr double largest_ratio = 0.25; // errors of 0.1 to 4 %, see above

/// size^2 / R: the area between two sides, times the root of the Gaussian curvature. That is the
/// ratio of the areas which the normals and the corners span.
double bulge(const Mesh &mesh, const Cell &surface, const std::array<Vector3, 4> &normals) {
  const Vector3 &first = mesh.nodes[surface.corners[0]];
  const Vector3 sides =
      (mesh.nodes[surface.corners[1]] - first).cross(mesh.nodes[surface.corners[2]] - first);
  const Vector3 turned = (normals[1] - normals[0]).cross(normals[2] - normals[0]);
  return std::sqrt(std::abs(sides.dot(turned)));
}

} // namespace

std::optional<TriangleLocking> find_locking(const Mesh &mesh,
                                            const std::vector<std::array<Vector3, 4>> &normals,
                                            const std::vector<double> &thickness) {
  TriangleLocking found;
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const Cell &surface = mesh.cells[i];
    if (surface.size != 3)
      continue;
    ++found.triangles;
    const double ratio = bulge(mesh, surface, normals[i]) / thickness[i];
    found.locking += ratio > largest_ratio;
    if (ratio <= found.size_ratio)
      continue;
    found.size_ratio = ratio;
    found.place = Vector3::Zero();
    for (const int node : surface.nodes())
      found.place += mesh.nodes[node] / 3;
  }
  return found.locking > 0 ? std::optional(found) : std::nullopt;
}

std::string locking_sentence(const TriangleLocking &locking) {
  std::ostringstream text;
  text.precision(2);
  text
      << locking.locking << " of " << locking.triangles
      << " triangles are large for a surface that is curved both ways and so thin: they may be too "
      << "stiff in bending (membrane locking). The worst, around " << coordinates(locking.place)
      << ", has size^2 / (radius thickness) = " << locking.size_ratio << "; up to " << largest_ratio
      << " is sound. Use quadrilaterals, or triangles smaller by a factor of "
      << std::sqrt(locking.size_ratio / largest_ratio) << " there";
  return text.str();
}

} // namespace vibroimpact::structure
