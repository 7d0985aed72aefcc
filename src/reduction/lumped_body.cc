#include "reduction/lumped_body.h"

namespace vibroimpact {

ReducedBody lumped_body(const BodyDefinition &definition) {
  if (definition.masses.empty())
    throw structure::DefinitionError("Body", definition.name, "Type",
                                     "= lumped needs at least one subsection Mass");
  const auto n = static_cast<Index>(definition.masses.size());
  ReducedBody body;
  body.name = definition.name;
  body.type = "lumped";
  body.mass = Vector::Zero(n);
  body.stiffness = Vector::Zero(n);
  body.damping = Matrix::Zero(n, n);
  body.base_participation = Matrix::Zero(n, 3);
  for (Index j = 0; j < n; ++j) {
    const LumpedMass &mass = definition.masses[j];
    if (!(mass.mass > 0))
      throw structure::DefinitionError("Mass", mass.name, "Mass", "must be greater than 0");
    body.mass[j] = mass.mass;
    body.stiffness[j] = mass.stiffness;
    body.damping(j, j) = mass.damping;
    body.base_participation(j, mass.axis) = mass.mass;
    body.total_mass[mass.axis] += mass.mass;
    BodyPoint point{mass.name, mass.position, Matrix::Zero(6, n)};
    point.rows(mass.axis, j) = 1;
    body.points.push_back(std::move(point));
  }
  return body;
}

} // namespace vibroimpact
