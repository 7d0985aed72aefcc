// A rotor on a carrying mass, for tests.
#pragma once

#include "support/lumped_models.h"

namespace vibroimpact::testing {

/// A mass [kg] that moves along x and y on equal springs [N/m] and dashpots [N s/m] to its base;
/// its only point is called "head".
inline std::shared_ptr<const reduction::ReducedBody>
plane_mass(const std::string &name, double mass, double stiffness, double damping) {
  auto body = std::make_shared<reduction::ReducedBody>();
  body->name = name;
  body->type = "lumped";
  body->mass = Vector::Constant(2, mass);
  body->stiffness = Vector::Constant(2, stiffness);
  body->damping = Vector::Constant(2, damping).asDiagonal();
  body->base_participation = Matrix::Zero(2, 3);
  Matrix rows = Matrix::Zero(6, 2);
  for (int axis = 0; axis < 2; ++axis) {
    body->base_participation(axis, axis) = mass;
    rows(axis, axis) = 1;
  }
  body->total_mass = Vector3(mass, mass, 0);
  body->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
  return body;
}

/// The rotation of a rotor with the given moment of inertia about its centre of mass [kg m^2].
inline std::shared_ptr<const reduction::ReducedBody> rotation(const std::string &name,
                                                              double inertia) {
  auto body = std::make_shared<reduction::ReducedBody>();
  body->name = name;
  body->type = "rotor";
  body->mass = Vector::Constant(1, inertia);
  body->stiffness = Vector::Zero(1);
  body->damping = Matrix::Zero(1, 1);
  body->base_participation = Matrix::Zero(1, 3);
  Matrix rows = Matrix::Zero(6, 1);
  rows(5, 0) = 1;
  body->points.push_back({.name = "shaft", .position = Vector3::Zero(), .rows = rows});
  return body;
}

/// Puts the rotation (body `index`) onto a point of the model, turning from x to y.
inline void put_rotor(model::Model &model, std::size_t index, const std::string &at, double mass,
                      double eccentricity, std::optional<model::Motor> motor = std::nullopt,
                      double initial_speed = 0) {
  model::Rotor rotor;
  rotor.name = model.bodies()[index]->name;
  rotor.angle = model.offset(index);
  rotor.mass = mass;
  rotor.eccentricity = eccentricity;
  rotor.initial_speed = initial_speed;
  rotor.motor = motor;
  model::PointReference point;
  model.find_point(at, point);
  model.add_rotor(std::move(rotor), point, Vector3::UnitX(), Vector3::UnitY());
}

} // namespace vibroimpact::testing
