// Small models for tests: single masses on springs, made directly as reduced bodies.
#pragma once

#include "contact/contact_set.h"
#include "model/model.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::testing {

/// A mass [kg] that moves along x on a spring [N/m] and a dashpot [N s/m] to its base; its only
/// point is called "head".
inline std::shared_ptr<const reduction::ReducedBody>
single_mass(const std::string &name, double mass, double stiffness, double damping) {
  auto body = std::make_shared<reduction::ReducedBody>();
  body->name = name;
  body->type = "lumped";
  body->mass = Vector::Constant(1, mass);
  body->stiffness = Vector::Constant(1, stiffness);
  body->damping = Matrix::Constant(1, 1, damping);
  body->base_participation = Matrix::Zero(1, 3);
  body->base_participation(0, 0) = mass;
  body->total_mass = Vector3(mass, 0, 0);
  Matrix rows = Matrix::Zero(6, 1);
  rows(0, 0) = 1;
  body->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
  return body;
}

/// Contact of two points along x; an empty second side is a fixed stop.
inline contact::ContactPair contact_along_x(const model::Model &model, const std::string &side_a,
                                            const std::string &side_b, double clearance,
                                            std::shared_ptr<const contact::ContactLaw> law) {
  model::PointReference a;
  model.find_point(side_a, a);
  model::Projection gap = model.displacement(a, Vector3::UnitX(), true);
  gap.row *= -1;
  for (double &base_coefficients : gap.base_coefficients)
    base_coefficients *= -1;
  if (!side_b.empty()) {
    model::PointReference b;
    model.find_point(side_b, b);
    const model::Projection other = model.displacement(b, Vector3::UnitX(), true);
    gap.row += other.row;
    for (std::size_t k = 0; k < gap.base_coefficients.size(); ++k)
      gap.base_coefficients[k] += other.base_coefficients[k];
  }
  return {.name = "heads",
          .side_a = side_a,
          .side_b = side_b.empty() ? "stop" : side_b,
          .clearance = clearance,
          .gap = gap,
          .law = std::move(law),
          .origin = "test"};
}

} // namespace vibroimpact::testing
