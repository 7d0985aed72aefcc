#include "structure/triangle_locking.h"

#include "structure/surface_normals.h"

#include <Eigen/Geometry>

#include <cmath>
#include <sstream>

namespace vibroimpact::structure {

namespace {

/// On a sphere of radius R this is size^2 / (R t) = 1, where errors begin to exceed 1 %.
constexpr double largest_share = 0.25;

struct Triangle {
  Vector3 middle;
  double sagitta = 0;
};

Triangle triangle(const Mesh &mesh, const Surface &surface, const std::array<Vector3, 4> &normals) {
  std::array<Vector3, 3> corners;
  for (int i = 0; i < 3; ++i)
    corners[i] = mesh.nodes[surface.corners[i]];
  const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
  const Vector3 own = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  for (Vector3 &corner : corners)
    corner -= middle;
  return {middle, sagitta(corners, std::span(normals).first(3), own)};
}

} // namespace

std::optional<TriangleLocking> find_locking(const Mesh &mesh,
                                            const std::vector<std::array<Vector3, 4>> &normals,
                                            const std::vector<double> &thickness) {
  TriangleLocking found;
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    if (mesh.surfaces[i].size != 3)
      continue;
    ++found.triangles;
    const Triangle one = triangle(mesh, mesh.surfaces[i], normals[i]);
    const double share = one.sagitta / thickness[i];
    found.locking += share > largest_share;
    if (share > found.sagitta_to_thickness) {
      found.sagitta_to_thickness = share;
      found.place = one.middle;
    }
  }
  return found.locking > 0 ? std::optional(found) : std::nullopt;
}

// The sagitta falls with the square of the size.
std::string locking_sentence(const TriangleLocking &locking) {
  std::ostringstream text;
  text.precision(2);
  text << locking.locking << " of " << locking.triangles
       << " triangles are too large for the curvature of their surface and thickness: they are too "
       << "stiff in bending (membrane locking). Over the worst, around "
       << coordinates(locking.place) << ", the surface rises by " << locking.sagitta_to_thickness
       << " times the thickness; up to " << largest_share
       << " is sound. Use quadrilaterals, or triangles smaller by a factor of "
       << std::sqrt(locking.sagitta_to_thickness / largest_share) << " there";
  return text.str();
}

} // namespace vibroimpact::structure
