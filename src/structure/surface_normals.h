// The normals of the smooth surface that a mesh of flat or warped elements stands for.
#pragma once

#include "structure/mesh.h"

namespace vibroimpact::structure {

/// For each surface the unit normals at its corners: the mean of the normals there of all surfaces
/// that meet in the node, weighted by their angles, in the sense of its own numbering. Surfaces
/// beyond a fold, whose normals differ by more than 30 degrees from its own, do not count. Entries
/// of a triangle's fourth corner are zero.
std::vector<std::array<Vector3, 4>> surface_normals(const Mesh &mesh);

/// Of the surface over an element [m]: half the largest turn of a corner's normal against the
/// element's own, times the distance of that corner from the middle. `corners` count from the
/// middle.
double sagitta(std::span<const Vector3> corners, std::span<const Vector3> normals,
               const Vector3 &own);

} // namespace vibroimpact::structure
