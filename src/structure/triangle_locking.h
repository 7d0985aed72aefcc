// Where triangles are too large for the curvature of their surface.
//
// A triangle lies in its plane. Bending without stretching turns its corners against each other
// about axes of the surface, of which a part lies along the triangle's normal: to the drilling
// rotation it looks like bending in the plane. The energy of this grows against that of bending
// with (s/t)^2, s being the sagitta of the surface over the triangle and t the thickness: on a
// sphere, of radius R, 4 s/t = size^2 / (R t) and the ratio is (4 s/t)^2 / 80 (the hemisphere of
// docs/gallery/plates-and-shells.md); on a twisted strip it is a few times that.
#pragma once

#include "structure/mesh.h"

#include <optional>

namespace vibroimpact::structure {

struct TriangleLocking {
  int triangles = 0; ///< of the mesh
  int locking = 0;   ///< with a sagitta of more than a quarter of the thickness
  /// The worst of them.
  double sagitta_to_thickness = 0;
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
