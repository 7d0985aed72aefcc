#include "cases.h"

#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "exact_bumpers.h"
#include "sides.h"

namespace vibroimpact::benchmarks {

namespace {

using namespace contact;
using namespace model;

Vector one(double value) { return Vector::Constant(1, value); }

std::shared_ptr<const reduction::ReducedBody> mass(const std::string &name, double mass,
                                                   double stiffness, double damping) {
  return body_along_x(name, one(mass), one(stiffness), one(damping), one(1));
}

Projection along_x(const Model &model, std::size_t body, bool absolute) {
  return model.displacement({.body = body, .point = 0}, Vector3::UnitX(), absolute);
}

Problem problem_of(const Bumpers &system) {
  Model model({mass("mass", 1, 1, 2 * system.xi)});
  model.add_base_motion(
      "ground", std::make_shared<Harmonic>(Given::acceleration, system.base(), system.beta, 0), {0},
      Vector3::UnitX());
  const auto law = std::make_shared<KelvinVoigtBumper>(system.lambda, system.dashpot());
  ContactSet contacts({contact_of_heads(model, "mass", "", 1, system.delta, law),
                       contact_of_heads(model, "mass", "", -1, system.delta, law)});
  const Projection recorded = along_x(model, 0, false);
  return {.model = std::move(model), .contacts = std::move(contacts), .recorded = recorded};
}

Problem problem_of(const Bilinear &system) {
  Model model({mass("first", system.mass[0], system.stiffness[0], system.damping[0]),
               mass("second", system.mass[1], system.stiffness[1], system.damping[1])});
  model.add_base_motion(
      "table", std::make_shared<Harmonic>(Given::displacement, system.base, system.forcing, 0),
      {0, 1}, Vector3::UnitX());
  ContactSet contacts({contact_of_heads(model, "first", "second", 1, system.gap,
                                        std::make_shared<LinearPenalty>(system.penalty))});
  const Projection recorded = along_x(model, 0, true);
  return {.model = std::move(model), .contacts = std::move(contacts), .recorded = recorded};
}

Problem problem_of(const Absorber &system) {
  Model model({mass("floor", system.m1, system.k1, system.c1), mass("damper", system.m2, 0, 0)});
  model.add_force("wind",
                  std::make_shared<Harmonic>(Given::displacement, system.amplitude, system.forcing,
                                             std::numbers::pi / 2),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  Projection elongation = along_x(model, 1, false);
  elongation.row -= along_x(model, 0, false).row;
  model.add_connection({.name = "spring",
                        .side_a = "floor.head",
                        .side_b = "damper.head",
                        .elongation = elongation,
                        .stiffness = system.k2,
                        .damping = system.c2});
  const auto law = std::make_shared<Hertz>(HertzConstants{.stiffness = system.hertz});
  ContactSet contacts({contact_of_heads(model, "floor", "damper", 1, system.clearance[0], law),
                       contact_of_heads(model, "floor", "damper", -1, system.clearance[1], law)});
  const Projection recorded = along_x(model, 0, false);
  return {.model = std::move(model), .contacts = std::move(contacts), .recorded = recorded};
}

} // namespace

Case bumpers() {
  const Bumpers system{.xi = 0.1, .gamma = 5, .lambda = 10, .delta = 0.4, .beta = 1.2};
  Case result = case_of("bumpers", problem_of(system), system, system.delta, 300, 100);
  const Vector state = settled(problem_of(system), 2 * std::numbers::pi / system.omega(), 300);
  result.sides.push_back(exact_bumpers_side(system, {state[0], state[1], state[2], state[3]},
                                            100 * 2 * std::numbers::pi / system.omega()));
  return result;
}

Case bilinear_masses() {
  const Bilinear system{.mass = {1.80, 2.46},
                        .damping = {31.14, 19.13},
                        .stiffness = {430.00, 417.78},
                        .penalty = 1e5,
                        .gap = 2e-3,
                        .base = 10e-3,
                        .forcing = 2 * std::numbers::pi * 2.4};
  return case_of("bilinear masses", problem_of(system), system, system.base, 100, 100);
}

namespace {

Absorber steel_absorber() {
  const double steel = 1.541797e11;
  return {.m1 = 1000,
          .k1 = 3.95e4,
          .c1 = 452,
          .m2 = 22.67,
          .k2 = 2481.1,
          .c2 = 40.65,
          .clearance = {0.05, 0.0683 - 0.05},
          .hertz = steel,
          .amplitude = 800,
          .forcing = 7.23};
}

} // namespace

Case absorber() {
  const Absorber system = steel_absorber();
  return case_of("absorber, Hertz", problem_of(system), system, 0.05, 1500, 20);
}

Case absorber_from_rest() {
  const Absorber system = steel_absorber();
  return case_of("absorber, from rest", problem_of(system), system, 0.05, 0, 50);
}

} // namespace vibroimpact::benchmarks
