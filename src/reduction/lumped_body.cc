#include "reduction/lumped_body.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::reduction {

namespace {

constexpr int first_rotation = 3;

/// A coordinate of a mass: what it weighs and what holds it.
struct Coordinate {
  double inertia = 0;
  Mount mount;
};

Coordinate coordinate(const LumpedMass &mass, int axis) {
  const bool turns = axis >= first_rotation;
  Coordinate one = turns ? Coordinate{mass.inertia[axis - first_rotation], mass.rotational_mount}
                         : Coordinate{mass.mass, mass.mount};
  if (!(one.inertia > 0))
    throw structure::DefinitionError("Mass", mass.name, turns ? "Rotary inertia" : "Mass",
                                     "must be greater than 0 for each Axis");
  if (mass.damping_ratio)
    one.mount.damping = 2 * *mass.damping_ratio * std::sqrt(one.mount.stiffness * one.inertia);
  return one;
}

// A coordinate for each axis, from coordinate `first` on; returns the next free one.
Index add_mass(const LumpedMass &mass, Index first, ReducedBody &body) {
  BodyPoint point{
      .name = mass.name, .position = mass.position, .rows = Matrix::Zero(6, body.size())};
  for (const int axis : mass.axes) {
    const Coordinate one = coordinate(mass, axis);
    body.mass[first] = one.inertia;
    body.stiffness[first] = one.mount.stiffness;
    body.damping(first, first) = one.mount.damping;
    if (axis < first_rotation) {
      body.base_participation(first, axis) = mass.mass;
      body.total_mass[axis] += mass.mass;
    }
    point.rows(axis, first) = 1;
    ++first;
  }
  body.points.push_back(std::move(point));
  return first;
}

// u + theta x r
BodyPoint carried_point(const LumpedPoint &definition, const ReducedBody &body) {
  const auto carrier =
      std::find_if(body.points.begin(), body.points.end(),
                   [&](const BodyPoint &point) { return point.name == definition.mass; });
  if (carrier == body.points.end())
    throw structure::DefinitionError("Point", definition.name, "At",
                                     "must name a Mass of the body");
  BodyPoint point = *carrier;
  point.name = definition.name;
  point.position += definition.arm;
  for (Index j = 0; j < body.size(); ++j)
    point.rows.col(j).head<3>() += Vector3(point.rows.col(j).tail<3>()).cross(definition.arm);
  return point;
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
  for (const LumpedPoint &point : definition.lumped_points)
    body.points.push_back(carried_point(point, body));
  return body;
}

} // namespace vibroimpact::reduction
