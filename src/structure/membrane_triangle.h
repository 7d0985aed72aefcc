// The membrane part of the shell elements: a flat triangle with two in-plane displacements [m] and
// the rotation about its normal (drilling) [rad] at each corner.
//
// It is the optimal member of Felippa's template of such triangles (felippa2003): a basic stiffness
// that passes the patch test, with the drilling rotations as true rotations of the material, and a
// higher-order stiffness that makes in-plane bending exact for rectangles of any aspect ratio that
// are cut into two triangles. Drilling rotations therefore need no penalty and no artificial
// stiffness, and beams and folded shells meet the element with a proper sixth rotation.
#pragma once

#include "structure/shell_properties.h"

#include <Eigen/Core>

#include <array>

namespace vibroimpact::structure {

using MembraneMatrix = Eigen::Matrix<double, 9, 9>;

/// Corners counter-clockwise in the plane [m]. Rows: u_x, u_y, drilling of corner 1, 2, 3.
MembraneMatrix membrane_triangle(const std::array<Eigen::Vector2d, 3> &corners,
                                 const ShellProperties &properties);

/// Its mean strains (e_x, e_y, 2 e_xy) from the nodal displacements.
Eigen::Matrix<double, 3, 9> membrane_strain(const std::array<Eigen::Vector2d, 3> &corners);

} // namespace vibroimpact::structure
