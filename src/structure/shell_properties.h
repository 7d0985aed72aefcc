// Stiffness and inertia of a thin or thick homogeneous shell per unit area, from its thickness and
// its material.
#pragma once

#include "structure/shell_definition.h"

#include <Eigen/Core>

namespace vibroimpact::structure {

struct ShellProperties {
  double thickness = 0;     ///< [m]
  double poisson_ratio = 0; ///< of the isotropic material
  /// Plane stress times thickness: (N_11, N_22, N_12) from (e_11, e_22, 2 e_12) [N/m].
  Eigen::Matrix3d membrane_stiffness = Eigen::Matrix3d::Zero();
  /// (M_11, M_22, M_12) from (k_11, k_22, 2 k_12) [N m].
  Eigen::Matrix3d bending_stiffness = Eigen::Matrix3d::Zero();
  double shear_stiffness = 0; ///< 5/6 G t: transverse force per shear angle [N/m]
  double mass_per_area = 0;   ///< [kg/m^2]
  double rotary_inertia = 0;  ///< rho t^3 / 12 [kg]
};

/// Throws DefinitionError of the section `kind` `name` for a thickness or material out of range.
ShellProperties shell_properties(double thickness, const Material &material,
                                 const std::string &kind, const std::string &name);

ShellProperties shell_properties(const MeshPart &part);

} // namespace vibroimpact::structure
