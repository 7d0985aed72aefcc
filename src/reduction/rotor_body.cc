#include "reduction/rotor_body.h"

namespace vibroimpact::reduction {

ReducedBody rotor_body(const BodyDefinition &definition) {
  constexpr int rotation_z = 5;
  ReducedBody body;
  body.name = definition.name;
  body.type = "rotor";
  body.mass = Vector::Constant(1, definition.rotor.inertia);
  body.stiffness = Vector::Zero(1);
  body.damping = Matrix::Constant(1, 1, definition.rotor.friction);
  body.base_participation = Matrix::Zero(1, 3);
  BodyPoint shaft{.name = "shaft", .position = Vector3::Zero(), .rows = Matrix::Zero(6, 1)};
  shaft.rows(rotation_z, 0) = 1;
  body.points.push_back(std::move(shaft));
  return body;
}

} // namespace vibroimpact::reduction
