#include "cases.h"

#include "nonlinear_equations.h"
#include "sides.h"

namespace vibroimpact::benchmarks {

namespace {

using namespace model;

Problem problem_of(const Duffing &system) {
  const auto one = [](double value) { return Vector::Constant(1, value); };
  Model model({body_along_x("mass", one(1), one(1), one(system.damping), one(1))});
  model.add_force(
      "force", std::make_shared<Harmonic>(Given::displacement, system.amplitude, system.forcing, 0),
      {.body = 0, .point = 0}, Vector3::UnitX());
  const Projection along = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  model.add_connection({.name = "cubic",
                        .side_a = "mass.head",
                        .side_b = "ground",
                        .elongation = along,
                        .cubic_stiffness = 1});
  return {.model = std::move(model), .contacts = {}, .recorded = along};
}

// A point that moves along x and y, or turns about z.
std::shared_ptr<const reduction::ReducedBody> body(const std::string &name, const Vector &mass,
                                                   double stiffness, double damping, Index axis) {
  auto body = std::make_shared<reduction::ReducedBody>();
  const Index n = mass.size();
  body->name = name;
  body->type = "lumped";
  body->mass = mass;
  body->stiffness = Vector::Constant(n, stiffness);
  body->damping = Vector::Constant(n, damping).asDiagonal();
  body->base_participation = Matrix::Zero(n, 3);
  Matrix rows = Matrix::Zero(6, n);
  for (Index j = 0; j < n; ++j)
    rows(axis + j, j) = 1;
  body->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
  return body;
}

Problem problem_of(const MotorOnFrame &system) {
  constexpr Index rotation = 5;
  Model model(
      {body("frame", Vector::Constant(2, system.frame), system.stiffness, system.damping, 0),
       body("disc", Vector::Constant(1, system.inertia), 0, 0, rotation)});
  Rotor rotor;
  rotor.name = "disc";
  rotor.angle = model.offset(1);
  rotor.mass = system.rotor;
  rotor.eccentricity = system.eccentricity;
  rotor.motor = Motor{.starting_torque = system.starting_torque,
                      .slope = system.slope,
                      .time_constant = system.time_constant};
  model.add_rotor(std::move(rotor), {.body = 0, .point = 0}, Vector3::UnitX(), Vector3::UnitY());
  const Projection recorded = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  return {.model = std::move(model), .contacts = {}, .recorded = recorded};
}

} // namespace

Case duffing() {
  const Duffing system{.damping = 0.05, .amplitude = 0.5, .forcing = 1.2};
  return case_of("Duffing", problem_of(system), system, 1, 100, 20);
}

Case motor_on_frame() {
  const MotorOnFrame system{.frame = 3,
                            .stiffness = 800,
                            .damping = 6,
                            .rotor = 2,
                            .eccentricity = 0.01,
                            .inertia = 0.05,
                            .starting_torque = 30,
                            .slope = 2,
                            .time_constant = 0.1};
  return case_of("rotor with motor", problem_of(system), system, system.eccentricity, 100, 20);
}

} // namespace vibroimpact::benchmarks
