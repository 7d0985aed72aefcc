#include "structure/shell_properties.h"

namespace vibroimpact::structure {

namespace {

constexpr double shell_shear_correction = 5.0 / 6.0; // of a homogeneous thickness

void check(double thickness, const Material &material, const std::string &kind,
           const std::string &name) {
  if (!(thickness > 0))
    throw DefinitionError(kind, name, "Thickness", "must be greater than 0");
  if (!(material.young_modulus > 0))
    throw DefinitionError(kind, name, "Young modulus", "must be greater than 0");
  if (!(material.poisson_ratio > -1 && material.poisson_ratio <= 0.5))
    throw DefinitionError(kind, name, "Poisson ratio", "must be greater than -1 and at most 0.5");
  if (!(material.density >= 0))
    throw DefinitionError(kind, name, "Density", "must not be negative");
}

} // namespace

ShellProperties shell_properties(double thickness, const Material &material,
                                 const std::string &kind, const std::string &name) {
  check(thickness, material, kind, name);
  const double nu = material.poisson_ratio;
  ShellProperties properties;
  properties.thickness = thickness;
  properties.poisson_ratio = nu;
  properties.membrane_stiffness << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  properties.membrane_stiffness *= material.young_modulus * thickness / (1 - nu * nu);
  properties.bending_stiffness = properties.membrane_stiffness * thickness * thickness / 12;
  properties.shear_stiffness =
      shell_shear_correction * material.young_modulus / (2 * (1 + nu)) * thickness;
  properties.mass_per_area = material.density * thickness;
  properties.rotary_inertia = properties.mass_per_area * thickness * thickness / 12;
  return properties;
}

ShellProperties shell_properties(const MeshPart &part) {
  return shell_properties(part.thickness, part.material, "Shell", part.name);
}

} // namespace vibroimpact::structure
