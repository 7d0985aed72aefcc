#include "model/excitation.h"

#include "model/connection.h"
#include "model/direction.h"
#include "model/histories.h"
#include "model/piecewise_function.h"
#include "model/recorded_history.h"
#include "model/spin.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::model {

namespace {

parameters::Dimension amplitude_dimension(const std::string &type) {
  if (type == "force")
    return parameters::dimension::force;
  if (type == "torque")
    return parameters::dimension::torque;
  if (type == "unbalance")
    return {.length = 1, .mass = 1};
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

HistoryContext read_context(const parameters::Values &root, const std::string &name,
                            const parameters::Values &excitation) {
  const std::string type = excitation.choice("Type");
  return {.name = name,
          .type = type,
          .given = given_quantity(type),
          .moves_base = type.starts_with("base"),
          .dimension = amplitude_dimension(type),
          .coherent = read_coherence(root, name),
          .file_folder = root.text("File folder"),
          .file_checksums = root.names("File checksums")};
}

// Gravity is constant; its history need not be chosen.
TimeFunctionPointer read_gravity(const parameters::Values &excitation) {
  if (excitation.given("History") && excitation.choice("History") != "constant")
    excitation.reject("History",
                      "History must be constant when Type = gravity, for gravity is constant");
  for (const char *key : {"Frequency", "Phase"})
    if (excitation.given(key))
      excitation.reject(key, std::string(key) + " must not be set when Type = gravity");
  excitation.require("Amplitude");
  return make_constant(Given::displacement,
                       excitation.quantity_of("Amplitude", parameters::dimension::acceleration));
}

void check_connections(const parameters::Values &root, const parameters::Values &excitation) {
  const std::string type = excitation.choice("Type");
  if (excitation.given("Connections") && !type.starts_with("base"))
    excitation.reject("Connections", "must not be set when Type = " + type);
  for (const std::string &name : excitation.names("Connections")) {
    excitation.require_known("Connections", name, root.instances("Connection"));
    if (!joins_ground(root.instance("Connection", name)))
      excitation.reject("Connections", "must name connections between a point and ground, along a "
                                       "direction; " +
                                           name + " is none");
  }
}

// Where the grounds of connections move, none but those that are named.
std::vector<std::size_t> read_bodies(const parameters::Values &excitation, const Model &model) {
  if (excitation.given("Connections") && !excitation.given("Bodies"))
    return {};
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
    if (!model.bodies()[bodies.back()]->base_participation.allFinite())
      excitation.reject("Bodies", "must name bodies of which it is known how the base moves them; "
                                  "the modes of " +
                                      name + " come without their participation");
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

// The history is that of the spin.
void refuse_history(const parameters::Values &excitation) {
  for (const char *key : {"History", "Frequency"})
    if (excitation.given(key))
      excitation.reject(key, std::string(key) + " must not be set when Type = unbalance, which "
                                                "turns with its Spin");
}

void add_unbalance(const parameters::Values &root, const parameters::Values &excitation,
                   const std::string &name, const Vector3 &direction, Model &model) {
  refuse_history(excitation);
  const PointReference at = read_point(excitation, model);
  const Spin spin = read_spin(root, excitation, "Spin", model);
  if (std::find(spin.bodies.begin(), spin.bodies.end(), at.body) == spin.bodies.end())
    excitation.reject("At", "must be a point of a body that turns with Spin " + spin.name);
  if (std::abs(direction.dot(model.bodies()[at.body]->spin.axis)) > 1e-12)
    excitation.reject("Direction", "must be across the Spin axis of the body");
  excitation.require("Amplitude");
  model.add_unbalance(name, excitation.quantity_of("Amplitude", amplitude_dimension("unbalance")),
                      spin.speed, at, direction, excitation.quantity("Phase"));
}

} // namespace

void declare_excitations(parameters::Section &root) {
  using namespace parameters;
  root.names("File checksums", "",
             "NAME HASH of the records that excitations read, separated by commas: files that "
             "must not have changed. A run enters them into the parameters it stores.");
  Section &excitation = root.named_subsection(
      "Excitation",
      "A force or torque at a point, a motion of the base, or gravity; all that act add up.");
  excitation
      .choice("Type", "base acceleration",
              {"force", "torque", "base displacement", "base velocity", "base acceleration",
               "gravity", "unbalance"},
              "The given quantity. Its amplitude stays constant when the frequency is swept. "
              "unbalance: "
              "a mass beside the axis of a body that turns; its force grows with the square of the "
              "speed.")
      .text("At", "",
            "Point the force or torque acts on, or where the unbalance is, as BODY.POINT.")
      .required("Type = force, torque or unbalance")
      .names("Bodies", "",
             "Bodies that stand on the moving base or have weight; empty means all, with "
             "Connections none.")
      .names("Connections", "",
             "Connections to ground whose ground moves, by the part of the motion along theirs: "
             "supports with motions of their own.")
      .text("Direction", "x",
            "Direction of the force, motion or gravity, or the axis about which a torque acts: x, "
            "-y or three numbers. Of an unbalance: where it is at time zero without Phase.")
      .text("Spin", "", "Section Spin with which the unbalance turns.")
      .required("Type = unbalance")
      .quantity("Amplitude", "", dimension::any, range::any, "A",
                "Amplitude, peak or constant value, in the unit of the type: N, N m, m, m/s or "
                "m/s^2; of an "
                "unbalance mass times distance, kg m.")
      .required("Type = gravity or unbalance, or History = harmonic, ramped harmonic, sine sweep "
                "or constant")
      .quantity("Frequency", "", dimension::frequency, range::positive, "f",
                "Frequency in Hz or rad/s; a sweep replaces it.")
      .required("History = harmonic or ramped harmonic")
      .quantity("Phase", "0", dimension::angle, range::any, "phi", "Phase at time zero.");
  declare_histories(excitation);
  declare_coherence(root);
}

void add_excitations(const parameters::Values &root, const std::vector<std::string> &names,
                     Model &model) {
  for (const std::string &name : names) {
    const parameters::Values excitation = root.instance("Excitation", name);
    const Vector3 direction = read_direction(excitation, "Direction");
    const std::string type = excitation.choice("Type");
    check_connections(root, excitation);
    if (type == "gravity") {
      model.add_gravity(name, read_gravity(excitation), read_bodies(excitation, model), direction);
      continue;
    }
    if (excitation.given("Spin") && type != "unbalance")
      excitation.reject("Spin", "must not be set when Type = " + type);
    if (type == "unbalance") {
      add_unbalance(root, excitation, name, direction, model);
      continue;
    }
    auto function = create_history(excitation, read_context(root, name, excitation));
    if (type == "force" || type == "torque")
      model.add_force(name, std::move(function), read_point(excitation, model),
                      {direction, type == "torque"});
    else
      model.add_base_motion(name, std::move(function), read_bodies(excitation, model), direction);
  }
}

std::vector<std::string> record_checksums(const parameters::Values &root,
                                          const std::string &file_folder) {
  std::vector<std::string> checksums;
  for (const std::string &name : root.instances("Excitation")) {
    const std::string checksum = record_checksum(root.instance("Excitation", name), file_folder);
    if (!checksum.empty() &&
        std::find(checksums.begin(), checksums.end(), checksum) == checksums.end())
      checksums.push_back(checksum);
  }
  return checksums;
}

} // namespace vibroimpact::model
