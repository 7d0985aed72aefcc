#include "reduction/lumped_body.h"

namespace vibroimpact::reduction {

namespace {

// A coordinate for each axis, from coordinate `first` on; returns the next free one.
Index add_mass(const LumpedMass &mass, Index first, ReducedBody &body) {
  if (!(mass.mass > 0))
    throw structure::DefinitionError("Mass", mass.name, "Mass", "must be greater than 0");
  BodyPoint point{
      .name = mass.name, .position = mass.position, .rows = Matrix::Zero(6, body.size())};
  for (const int axis : mass.axes) {
    body.mass[first] = mass.mass;
    body.stiffness[first] = mass.stiffness;
    body.damping(first, first) = mass.damping;
    body.base_participation(first, axis) = mass.mass;
    body.total_mass[axis] += mass.mass;
    point.rows(axis, first) = 1;
    ++first;
  }
  body.points.push_back(std::move(point));
  return first;
}

} // namespace

ReducedBody lumped_body(const BodyDefinition &definition) {
  if (definition.masses.empty())
    throw structure::DefinitionError("Body", definition.name, "Type",
                                     "must not be lumped without a subsection Mass");
  Index n = 0;
  for (const LumpedMass &mass : definition.masses)
    n += static_cast<Index>(mass.axes.size());
  ReducedBody body;
  body.name = definition.name;
  body.type = "lumped";
  body.mass = Vector::Zero(n);
  body.stiffness = Vector::Zero(n);
  body.damping = Matrix::Zero(n, n);
  body.base_participation = Matrix::Zero(n, 3);
  Index first = 0;
  for (const LumpedMass &mass : definition.masses)
    first = add_mass(mass, first, body);
  return body;
}

} // namespace vibroimpact::reduction
