// A round disc on a shaft without mass whose damping turns with it, and dashpots that stand still:
//
//   m z'' + (c_e + c_i) z' + (k - i W c_i) z = 0,   z = x + i y
//
// with c_i = tau k. Motions exp(lambda t) follow from the quadratic equation; forward whirl is
// undamped at the speed W = w (1 + c_e / c_i), w = sqrt(k / m), where it turns with w (genta2005).
#pragma once

#include "model/model.h"
#include "reduction/lumped_body.h"

#include <cmath>
#include <complex>
#include <memory>

namespace vibroimpact::testing {

struct Jeffcott {
  double mass = 2, stiffness = 800, external = 3, retardation = 2.5e-3;

  double natural() const { return std::sqrt(stiffness / mass); }
  double internal() const { return retardation * stiffness; } ///< c_i
  double threshold() const { return natural() * (1 + external / internal()); }

  /// Forward whirl: the root with the positive imaginary part.
  std::complex<double> forward(double speed) const {
    const std::complex<double> c = external + internal(), k(stiffness, -speed * internal());
    const std::complex<double> root = std::sqrt(c * c - 4 * mass * k);
    return (-c + (root.imag() > 0 ? root : -root)) / (2 * mass);
  }

  std::shared_ptr<const reduction::ReducedBody> disc() const {
    reduction::BodyDefinition definition;
    definition.name = "disc";
    definition.type = reduction::BodyDefinition::Type::lumped;
    definition.masses = {
        {.name = "hub", .mass = mass, .axes = {0, 1}, .mount = {.stiffness = stiffness}}};
    definition.lumped_spin =
        structure::SpinAxis{.direction = Vector3::UnitZ(), .internal_damping = retardation};
    return std::make_shared<reduction::ReducedBody>(reduction::lumped_body(definition));
  }

  model::Model model(const model::SpinSpeed &speed) const {
    model::Model model({disc()});
    model.add_spin({.name = "shaft", .speed = speed, .bodies = {0}});
    for (const Vector3 &along : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY())})
      model.add_connection({.name = "dashpot",
                            .side_a = "disc.hub",
                            .side_b = "base",
                            .elongation = model.displacement({.body = 0, .point = 0}, along, false),
                            .damping = external});
    return model;
  }
};

/// Between a point and the base, along x and y.
inline model::Bearing bearing_at(const model::Model &model, const model::PointReference &point,
                                 const Eigen::Matrix2d &stiffness, const Eigen::Matrix2d &damping) {
  return {.name = "film",
          .side_a = model.point_name(point),
          .side_b = "base",
          .elongation = {model.displacement(point, Vector3::UnitX(), false),
                         model.displacement(point, Vector3::UnitY(), false)},
          .stiffness = stiffness,
          .damping = damping};
}

} // namespace vibroimpact::testing
