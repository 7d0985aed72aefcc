#include "structure/beam_properties.h"

namespace vibroimpact::structure {

namespace {

void check_material(const Material &material) {
  if (!(material.young_modulus > 0))
    throw DefinitionError("Material", "", "Young modulus", "must be greater than 0");
  if (!(material.poisson_ratio > -1 && material.poisson_ratio <= 0.5))
    throw DefinitionError("Material", "", "Poisson ratio", "must be greater than -1, at most 0.5");
  if (!(material.density >= 0))
    throw DefinitionError("Material", "", "Density", "must not be negative");
}

} // namespace

BeamProperties beam_properties(const SectionShape &shape, const Material &material) {
  check_material(material);
  const CrossSection section = cross_section(shape);
  const double shear_modulus = material.young_modulus / (2 * (1 + material.poisson_ratio));
  const double polar = section.second_moment_y + section.second_moment_z;
  BeamProperties properties{.axial_stiffness = material.young_modulus * section.area,
                            .torsional_stiffness = shear_modulus * section.torsion_constant,
                            .bending_stiffness_y = material.young_modulus * section.second_moment_y,
                            .bending_stiffness_z = material.young_modulus * section.second_moment_z,
                            .mass_per_length = material.density * section.area,
                            .polar_inertia = material.density * polar,
                            .polar_radius_squared = polar / section.area};
  if (shape.theory == BeamTheory::euler_bernoulli)
    return properties;
  properties.rotary_inertia_y = material.density * section.second_moment_y;
  properties.rotary_inertia_z = material.density * section.second_moment_z;
  if (shape.theory == BeamTheory::rayleigh)
    return properties;
  const auto [kappa_y, kappa_z] = shear_correction(shape, material.poisson_ratio);
  properties.shear_flexibility_y = 1 / (kappa_y * shear_modulus * section.area);
  properties.shear_flexibility_z = 1 / (kappa_z * shear_modulus * section.area);
  return properties;
}

PropertiesAlong properties_along(const SectionShape &shape, const Material &material,
                                 const AxialForce &axial_force, double begin, double end) {
  const auto force_at = [=](double along) {
    return axial_force.start + (axial_force.end - axial_force.start) * along;
  };
  const auto member_place = [=](double along) { return (1 - along) * begin + along * end; };
  const auto at = [=](double along) {
    BeamProperties properties = beam_properties(shape_at(shape, along), material);
    properties.axial_force = force_at(along);
    return properties;
  };
  if (tapered(shape))
    return [=](double along) { return at(member_place(along)); };
  const BeamProperties uniform = at(0);
  if (!axial_force.changes())
    return [uniform](double) { return uniform; };
  return [=](double along) {
    BeamProperties properties = uniform;
    properties.axial_force = force_at(member_place(along));
    return properties;
  };
}

} // namespace vibroimpact::structure
