#include "model/rotor_parameters.h"

#include "model/direction.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::model {

namespace {

PointReference read_base_point(const parameters::Values &rotor, const Model &model) {
  rotor.require("At");
  std::vector<std::string> known;
  for (const std::string &name : model.point_names()) {
    PointReference point;
    model.find_point(name, point);
    if (model.bodies()[point.body]->type != "rotor")
      known.push_back(name);
  }
  rotor.require_known("At", rotor.text("At"), known);
  PointReference at;
  model.find_point(rotor.text("At"), at);
  return at;
}

std::optional<Motor> read_motor(const parameters::Values &body) {
  if (!body.subsection_given("Motor"))
    return std::nullopt;
  const parameters::Values motor = body.subsection("Motor");
  motor.require("Starting torque");
  motor.require("Slope");
  motor.require("Time constant");
  return Motor{.starting_torque = motor.quantity("Starting torque"),
               .slope = motor.quantity("Slope"),
               .time_constant = motor.quantity("Time constant"),
               .torque_constant = motor.quantity("Torque constant"),
               .initial_torque = motor.quantity("Initial torque")};
}

void add_rotor(const parameters::Values &body, std::size_t index, Model &model) {
  const parameters::Values rotor = body.subsection("Rotor");
  const Vector3 first = read_direction(rotor, "First direction");
  const Vector3 second = read_direction(rotor, "Second direction");
  if (std::abs(first.dot(second)) > 1e-12)
    rotor.reject("Second direction", "Second direction must be perpendicular to First direction.");
  Rotor added{.name = model.bodies()[index]->name,
              .at = {},
              .angle = model.offset(index),
              .mass = rotor.quantity("Mass"),
              .eccentricity = rotor.quantity("Eccentricity"),
              .initial_angle = rotor.quantity("Initial angle"),
              .initial_speed = rotor.quantity("Initial speed"),
              .first = {},
              .second = {},
              .field_first = {},
              .field_second = {},
              .motor = read_motor(body)};
  model.add_rotor(std::move(added), read_base_point(rotor, model), first, second);
}

} // namespace

void add_rotors(const parameters::Values &root, Model &model) {
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    if (model.bodies()[b]->type == "rotor")
      add_rotor(root.instance("Body", model.bodies()[b]->name), b, model);
}

} // namespace vibroimpact::model
