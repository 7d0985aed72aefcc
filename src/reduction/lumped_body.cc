#include "reduction/lumped_body.h"

#include "structure/beam_spin.h"

#include <Eigen/Geometry>

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

bool turns(const structure::SpinAxis &spin, const LumpedMass &mass) {
  return spin.points.empty() ||
         std::find(spin.points.begin(), spin.points.end(), mass.name) != spin.points.end();
}

/// Of a mass that is round about the axis.
std::array<double, 2> round_inertia(const LumpedMass &mass, const Vector3 &axis) {
  const double polar = axis.cwiseAbs2().dot(mass.inertia);
  const double diametral = (mass.inertia.sum() - polar) / 2;
  const Eigen::Matrix3d round =
      diametral * Eigen::Matrix3d::Identity() + (polar - diametral) * axis * axis.transpose();
  if ((round - Eigen::Matrix3d(mass.inertia.asDiagonal())).norm() > 1e-6 * mass.inertia.norm())
    throw structure::DefinitionError("Mass", mass.name, "Rotary inertia",
                                     "must be equal about all directions across the Spin axis "
                                     "about which the mass turns");
  return {polar, diametral};
}

/// Adds what whirls of displacements or rotations.
void add_whirl(const Matrix &rows, double inertia, SpinMatrices &spin) {
  const Eigen::Matrix3d cross = structure::cross_matrix(spin.axis);
  spin.turning += inertia * rows.transpose() * cross * rows;
  spin.crosswise -= inertia * rows.transpose() * cross * cross * rows;
}

/// Of masses that only move: 2 a x u' and a x (a x u), by all of their motion.
void add_rotating_frame(const BodyDefinition &definition, const ReducedBody &body,
                        SpinMatrices &spin) {
  spin.rotating_frame = true;
  spin.gyroscopic = 2 * spin.turning;
  spin.centrifugal = -spin.crosswise;
  spin.centrifugal_load = Vector::Zero(body.size());
  for (const LumpedMass &mass : definition.masses) {
    const Vector3 arm = mass.position - definition.lumped_spin->through;
    const Vector3 across = arm - arm.dot(spin.axis) * spin.axis;
    if (turns(*definition.lumped_spin, mass))
      spin.centrifugal_load +=
          mass.mass * body.point(mass.name).rows.topRows(3).transpose() * across;
  }
}

/// The springs to the base of the masses that turn lose energy as they turn: C = tau k, N = -tau k
/// R (beam_spin.h), R = a x of the displacements that the mass has, and of its rotations.
void add_internal_damping(const BodyDefinition &definition, ReducedBody &body) {
  const structure::SpinAxis &axis = *definition.lumped_spin;
  const Eigen::Matrix3d cross = structure::cross_matrix(axis.direction);
  Matrix stiffness = Matrix::Zero(body.size(), body.size());
  Matrix turned = stiffness;
  for (const LumpedMass &mass : definition.masses) {
    if (!turns(axis, mass))
      continue;
    const auto add = [&](const Matrix &rows, double spring) {
      stiffness += spring * rows.transpose() * rows;
      turned += spring * rows.transpose() * cross * rows;
    };
    const Matrix &rows = body.point(mass.name).rows;
    add(rows.topRows(3), mass.mount.stiffness);
    add(rows.bottomRows(3), mass.rotational_mount.stiffness);
  }
  body.damping += axis.internal_damping * stiffness;
  if (!axis.rotating_frame)
    body.spin.circulatory = -axis.internal_damping * turned;
}

SpinMatrices spin_of(const BodyDefinition &definition, const ReducedBody &body) {
  const structure::SpinAxis &axis = *definition.lumped_spin;
  const Matrix none = Matrix::Zero(body.size(), body.size());
  SpinMatrices spin{.axis = axis.direction,
                    .rotating_frame = false,
                    .gyroscopic = none,
                    .centrifugal = {},
                    .centrifugal_load = {},
                    .turning = none,
                    .crosswise = none};
  for (const LumpedMass &mass : definition.masses) {
    if (!turns(axis, mass))
      continue;
    const Matrix &rows = body.point(mass.name).rows;
    add_whirl(rows.topRows(3), mass.mass, spin);
    if (mass.inertia.isZero(0))
      continue;
    if (axis.rotating_frame)
      throw structure::DefinitionError("Mass", mass.name, "Axis",
                                       "must name displacements alone when Frame = rotating");
    const auto [polar, diametral] = round_inertia(mass, axis.direction);
    add_whirl(rows.bottomRows(3), diametral, spin);
    spin.gyroscopic -= polar * rows.bottomRows(3).transpose() *
                       structure::cross_matrix(axis.direction) * rows.bottomRows(3);
  }
  if (axis.rotating_frame)
    add_rotating_frame(definition, body, spin);
  return spin;
}

void check_spinning(const BodyDefinition &definition) {
  for (const std::string &name : definition.lumped_spin->points)
    if (std::none_of(definition.masses.begin(), definition.masses.end(),
                     [&](const LumpedMass &mass) { return mass.name == name; }))
      throw structure::DefinitionError("Spin axis", "", "Points",
                                       "must name masses of the body, but there is no " + name);
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
  if (definition.lumped_spin) {
    check_spinning(definition);
    body.spin = spin_of(definition, body);
    if (definition.lumped_spin->internal_damping > 0)
      add_internal_damping(definition, body);
  }
  return body;
}

} // namespace vibroimpact::reduction
