// A mass that slides on a plane, or flies against it, with friction along two directions of it.
#pragma once

#include "model/time_function.h"
#include "support/friction_models.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::testing {

/// A mass with the coordinates x, y, z on springs along x and y; its only point is called "head".
struct Sled {
  double mass = 1, kx = 0, ky = 0;
  double weight = 0;             ///< along z [N]
  double pull_x = 0, pull_y = 0; ///< constant forces [N]
  bool driven = false;
  std::vector<double> start{}; ///< x, y, z, x', y', z'
};

inline std::shared_ptr<const reduction::ReducedBody> sled_body(const Sled &sled) {
  auto body = std::make_shared<reduction::ReducedBody>();
  body->name = "sled";
  body->type = "lumped";
  body->mass = Vector::Constant(3, sled.mass);
  body->stiffness = Vector3(sled.kx, sled.ky, 0);
  body->damping = Matrix::Zero(3, 3);
  body->base_participation = sled.mass * Matrix::Identity(3, 3);
  body->total_mass = Vector3::Constant(sled.mass);
  body->points.push_back(
      {.name = "head", .position = Vector3::Zero(), .rows = Matrix::Identity(6, 3)});
  return body;
}

inline model::Model sled_model(const Sled &sled) {
  model::Model model({sled_body(sled)});
  const auto push = [&](const char *name, double force, double phase, const Vector3 &direction) {
    model.add_force(
        name, std::make_shared<model::Harmonic>(model::Given::displacement, force, 0.8, phase),
        {.body = 0, .point = 0}, direction);
  };
  const double quarter = std::acos(0.0);
  if (sled.driven) {
    push("x", 0.9, quarter, Vector3::UnitX());
    push("y", 0.6, quarter - 1, Vector3::UnitY());
  }
  const auto pull = [&](const char *name, double force, const Vector3 &direction) {
    if (force != 0)
      model.add_force(name, model::make_constant(model::Given::displacement, force),
                      {.body = 0, .point = 0}, direction);
  };
  pull("pull x", sled.pull_x, Vector3::UnitX());
  pull("pull y", sled.pull_y, Vector3::UnitY());
  if (sled.weight != 0)
    model.add_gravity("weight",
                      model::make_constant(model::Given::displacement, sled.weight / sled.mass),
                      {0}, Vector3::UnitZ());
  return model;
}

/// Against the ground at z = 0.1, friction along x and y; where the normal force is constant, it
/// moves nothing.
inline contact::ContactPair on_the_ground(const model::Model &model,
                                          std::shared_ptr<const contact::ContactLaw> law,
                                          const std::vector<Vector3> &directions) {
  const bool constant = law->always_in_contact();
  contact::ContactPair pair =
      contact_along_x(model, "sled.head", "", constant ? 0 : 0.1, std::move(law));
  pair.accept_initial_penetration = true;
  model::PointReference point;
  model.find_point("sled.head", point);
  const auto along = [&](const Vector3 &direction) {
    model::Projection seen = model.displacement(point, direction, true);
    seen.row *= -1;
    for (double &coefficient : seen.base_coefficients)
      coefficient *= -1;
    return seen;
  };
  for (const Vector3 &direction : directions)
    pair.tangential.push_back({.slip = along(direction)});
  pair.gap = along(Vector3::UnitZ());
  if (constant)
    pair.gap.row.setZero();
  return pair;
}

inline std::vector<Vector3> across_the_ground() { return {Vector3::UnitX(), Vector3::UnitY()}; }

/// As exact as a method can be; stock ones need an absolute tolerance where forces end.
inline motion::Settings precise(const std::string &method) {
  motion::Settings settings = settings_of(method);
  settings.relative_tolerance = 1e-13;
  if (method == "exact")
    settings.absolute_tolerance = 0;
  return settings;
}

/// Flies against the ground and slides on, along one slanted direction: by how much the states [m,
/// m/s] with friction along that direction and with friction along x and y differ in the end.
inline double
apart_along_one_direction(const std::shared_ptr<const contact::ContactLaw> &normal,
                          const std::shared_ptr<const contact::TangentialLaw> &along_one,
                          const std::shared_ptr<const contact::TangentialLaw> &along_two,
                          const std::string &method) {
  const double angle = 0.7;
  const Vector3 ahead(std::cos(angle), std::sin(angle), 0);
  const model::Model model = sled_model({.mass = 2, .kx = 3e5, .ky = 3e5});
  const auto moved = [&](const std::shared_ptr<const contact::TangentialLaw> &friction,
                         const std::vector<Vector3> &directions) {
    const contact::ContactSet contacts({on_the_ground(
        model, std::make_shared<contact::FrictionalLaw>(normal, friction), directions)});
    motion::Trajectory trajectory(model, contacts, precise(method));
    trajectory.start(0, Vector3(0, 0, 0.099), 0.36 * ahead + Vector3::UnitZ());
    trajectory.advance(0.03, motion::Observers({}));
    return Vector(trajectory.state().head(6));
  };
  return (moved(along_one, {ahead}) - moved(along_two, across_the_ground())).cwiseAbs().maxCoeff();
}

} // namespace vibroimpact::testing
