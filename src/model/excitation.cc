#include "model/excitation.h"

#include "model/direction.h"

namespace vibroimpact {

namespace {

parameters::Dimension amplitude_dimension(const std::string &type) {
  if (type == "force")
    return parameters::dimension::force;
  if (type == "base displacement")
    return parameters::dimension::length;
  return type == "base velocity" ? parameters::dimension::velocity
                                 : parameters::dimension::acceleration;
}

Given given_quantity(const std::string &type) {
  if (type == "base acceleration")
    return Given::acceleration;
  return type == "base velocity" ? Given::velocity : Given::displacement;
}

std::shared_ptr<const TimeFunction> read_function(const parameters::Values &excitation) {
  const std::string type = excitation.choice("Type");
  excitation.require("Amplitude");
  excitation.require("Frequency");
  return std::make_shared<Harmonic>(given_quantity(type),
                                    excitation.quantity_of("Amplitude", amplitude_dimension(type)),
                                    excitation.quantity("Frequency"), excitation.quantity("Phase"));
}

std::vector<std::size_t> read_bodies(const parameters::Values &excitation, const Model &model) {
  std::vector<std::string> known;
  for (const auto &body : model.bodies())
    known.push_back(body->name);
  std::vector<std::string> names = excitation.names("Bodies");
  if (names.empty())
    names = known;
  std::vector<std::size_t> bodies;
  for (const std::string &name : names) {
    excitation.require_known("Bodies", name, known);
    bodies.push_back(model.find_body(name));
  }
  return bodies;
}

PointReference read_point(const parameters::Values &excitation, const Model &model) {
  excitation.require("At");
  PointReference point;
  const std::string name = excitation.text("At");
  excitation.require_known("At", name, model.point_names());
  model.find_point(name, point);
  return point;
}

} // namespace

void declare_excitations(parameters::Section &root) {
  using namespace parameters;
  root.named_subsection("Excitation", "A force at a point or a motion of the base, harmonic in "
                                      "time: amplitude sin(frequency t + phase).")
      .choice("Type", "base acceleration",
              {"force", "base displacement", "base velocity", "base acceleration"},
              "What the amplitude is of. It stays constant when the frequency is swept.")
      .text("At", "", "Point the force acts on, as BODY.POINT.")
      .names("Bodies", "", "Bodies that stand on the moving base; empty means all.")
      .text("Direction", "x", "Direction of the force or the motion: x, -y or three numbers.")
      .quantity("Amplitude", "", dimension::any, range::any, "A",
                "Amplitude, in the unit of the type: N, m, m/s or m/s^2.")
      .quantity("Frequency", "", dimension::frequency, range::positive, "f",
                "Frequency in Hz or rad/s; a sweep replaces it.")
      .quantity("Phase", "0", dimension::angle, range::any, "phi", "Phase at time zero.");
}

void add_excitations(const parameters::Values &root, const std::vector<std::string> &names,
                     Model &model) {
  for (const std::string &name : names) {
    const parameters::Values excitation = root.instance("Excitation", name);
    const Vector3 direction = read_direction(excitation, "Direction");
    auto function = read_function(excitation);
    if (excitation.choice("Type") == "force")
      model.add_force(name, std::move(function), read_point(excitation, model), direction);
    else
      model.add_base_motion(name, std::move(function), read_bodies(excitation, model), direction);
  }
}

} // namespace vibroimpact
