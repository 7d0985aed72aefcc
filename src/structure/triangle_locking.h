// Where triangles are too large for the curvature of their surface.
//
// A triangle lies in its plane. Bending without stretching turns its corners against each other
// about axes of the surface, of which a part lies along the triangle's normal: to the drilling
// rotation it looks like bending in the plane. In a surface that curves one way only, most bending
// turns about the straight lines of the surface, along which the normal is constant, and little of
// it is felt. What counts is the Gaussian curvature 1/R^2: with m = size^2 / (R t), t the
// thickness, the energy of this is 0.02 m^2 of that of bending on a hemisphere, 0.08 m^2 on a
// hyperbolic paraboloid, 0.2 m^2 on a twisted strip and 0.4 m^2 on a skewed mesh of it
// (docs/gallery/plates-and-shells.md).
#pragma once

#include "structure/mesh.h"

#include <optional>

namespace vibroimpact::structure {

struct TriangleLocking {
  int triangles = 0; ///< of the mesh
  int locking = 0;   ///< with m > 1/4
  /// The worst of them.
  double size_ratio = 0;           ///< m
  Vector3 place = Vector3::Zero(); ///< its middle [m]
};

/// `normals` as from surface_normals(), `thickness` [m] of each surface. Nothing when none is too
/// large.
std::optional<TriangleLocking> find_locking(const Mesh &mesh,
                                            const std::vector<std::array<Vector3, 4>> &normals,
                                            const std::vector<double> &thickness);

/// A sentence: how many, the worst, and what helps.
std::string locking_sentence(const TriangleLocking &locking);

} // namespace vibroimpact::structure
