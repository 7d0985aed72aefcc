// Particles in rings, for tests.
#pragma once

#include "contact/curved_gap_law.h"
#include "contact/friction/frictional_law.h"
#include "contact/laws/linear_penalty.h"
#include "support/friction_models.h"

#include <cmath>
#include <complex>
#include <memory>
#include <string>
#include <utility>

namespace vibroimpact::testing {

/// Of a point with coordinates along x and y and a ring that is fixed in space, or about another
/// such point; tangential: none without friction.
inline contact::ContactPair
ring_about_z(const model::Model &model, const std::string &side_a, const std::string &side_b,
             double clearance, std::shared_ptr<const contact::ContactLaw> normal,
             std::shared_ptr<const contact::TangentialLaw> tangential = nullptr,
             double surface_speed = 0,
             contact::CircularGap::Kind kind = contact::CircularGap::Kind::inside,
             contact::AcrossAxis centres = {}) {
  const auto relative = [&](const Vector3 &direction) {
    model::PointReference point;
    model.find_point(side_a, point);
    model::Projection seen = model.displacement(point, direction, true);
    seen.row *= -1;
    for (double &coefficient : seen.base_coefficients)
      coefficient *= -1;
    if (side_b.empty())
      return seen;
    model.find_point(side_b, point);
    const model::Projection other = model.displacement(point, direction, true);
    seen.row += other.row;
    for (std::size_t k = 0; k < seen.base_coefficients.size(); ++k)
      seen.base_coefficients[k] += other.base_coefficients[k];
    return seen;
  };
  contact::ContactPair pair{.name = "ring",
                            .side_a = side_a,
                            .side_b = side_b.empty() ? "stop" : side_b,
                            .clearance = clearance,
                            .gap = relative(Vector3::UnitX()),
                            .law = std::make_shared<contact::CurvedGapLaw>(std::move(normal)),
                            .accept_initial_penetration = true,
                            .origin = "test"};
  const model::Projection second = relative(Vector3::UnitY());
  pair.circle = std::make_shared<contact::CircularGap>(kind, clearance, Vector3::UnitZ(), second,
                                                       centres, surface_speed);
  if (tangential) {
    pair.law = std::make_shared<contact::FrictionalLaw>(pair.law, std::move(tangential));
    pair.tangential.push_back({.slip = second, .surface_speed = surface_speed});
  }
  return pair;
}

/// A mass with the coordinates x and y on equal springs and dashpots.
inline std::shared_ptr<const reduction::ReducedBody> isotropic(const std::string &name, double mass,
                                                               double stiffness, double damping) {
  auto body = std::make_shared<reduction::ReducedBody>(*particle(name, mass, stiffness));
  body->stiffness = Vector::Constant(2, stiffness);
  body->damping = damping * Matrix::Identity(2, 2);
  return body;
}

/// Unit mass and stiffness; eccentricity [m], speed [rad/s]. At t = 0 the unbalance is along x.
inline model::Model unbalanced_rotor(double damping, double eccentricity, double speed) {
  model::Model model({isotropic("rotor", 1, 1, damping)});
  const auto turn = [&](const char *name, double phase, const Vector3 &direction) {
    model.add_force(name,
                    std::make_shared<model::Harmonic>(model::Given::displacement,
                                                      eccentricity * speed * speed, speed, phase),
                    {.body = 0, .point = 0}, direction);
  };
  turn("along", std::acos(0.0), Vector3::UnitX());
  turn("across", 0, Vector3::UnitY());
  return model;
}

} // namespace vibroimpact::testing
