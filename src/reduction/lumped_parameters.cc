#include "reduction/lumped_parameters.h"

#include "reduction/body_sections.h"

#include <algorithm>
#include <array>

namespace vibroimpact::reduction {

namespace {

using namespace sections;

constexpr std::array axis_names = {"x", "y", "z", "rx", "ry", "rz"};
constexpr int first_rotation = 3;

std::vector<int> read_axes(const Values &section) {
  std::vector<int> axes;
  for (const std::string &name : section.names("Axis")) {
    section.require_known("Axis", name, {axis_names.begin(), axis_names.end()});
    axes.push_back(static_cast<int>(std::find(axis_names.begin(), axis_names.end(), name) -
                                    axis_names.begin()));
  }
  if (axes.empty())
    section.reject("Axis", "must name at least one of x, y, z, rx, ry, rz");
  return axes;
}

/// What a mass has of displacements or of rotations, if its axes name none of them, must not be
/// set.
void check_keys(const Values &section, bool moves, const std::string &axes,
                std::initializer_list<const char *> keys) {
  for (const char *key : keys)
    if (!moves && section.given(key))
      section.reject(key, "must not be set when Axis names none of " + axes);
}

Vector3 read_inertia(const Values &section) {
  const std::vector<double> values = section.quantities("Rotary inertia");
  if (values.size() == 2)
    section.reject("Rotary inertia", "must be one value, or three about x, y and z");
  return values.size() == 1 ? Vector3(Vector3::Constant(values[0]))
                            : vector3(section, "Rotary inertia");
}

void read_damping_ratio(const Values &section, LumpedMass &mass) {
  if (!section.has("Damping ratio"))
    return;
  for (const char *key : {"Damping", "Rotational damping"})
    if (section.given(key))
      section.reject(key, "must not be set when Damping ratio is");
  if (mass.mount.stiffness == 0 && mass.rotational_mount.stiffness == 0)
    section.reject("Damping ratio", "must not be set without a spring to the base");
  mass.damping_ratio = section.quantity("Damping ratio");
}

LumpedMass read_mass(const Values &section, const std::string &name) {
  LumpedMass mass{
      .name = name, .axes = read_axes(section), .position = vector3(section, "Position")};
  const bool turns = *std::max_element(mass.axes.begin(), mass.axes.end()) >= first_rotation;
  const bool moves = *std::min_element(mass.axes.begin(), mass.axes.end()) < first_rotation;
  check_keys(section, moves, "x, y, z", {"Mass", "Stiffness", "Damping"});
  check_keys(section, turns, "rx, ry, rz",
             {"Rotary inertia", "Rotational stiffness", "Rotational damping"});
  if (moves) {
    section.require("Mass");
    mass.mass = section.quantity("Mass");
    mass.mount = {section.quantity("Stiffness"), section.quantity("Damping")};
  }
  if (turns) {
    section.require("Rotary inertia");
    mass.inertia = read_inertia(section);
    mass.rotational_mount = {section.quantity("Rotational stiffness"),
                             section.quantity("Rotational damping")};
  }
  read_damping_ratio(section, mass);
  return mass;
}

LumpedPoint read_lumped_point(const Values &section, const std::string &name,
                              const std::vector<std::string> &masses) {
  for (const char *key :
       {"Position", "Near", "Node", "Mass", "Rotary inertia", "Products of inertia", "Offset",
        "Static stiffness", "Residual flexibility"})
    if (section.given(key))
      section.reject(key, "must not be set when Type = lumped");
  if (std::find(masses.begin(), masses.end(), name) != masses.end())
    section.reject_section("its name must not be that of a Mass, which is a point already");
  section.require("At");
  section.require_known("At", section.text("At"), masses);
  return {.name = name, .mass = section.text("At"), .arm = vector3(section, "Arm")};
}

} // namespace

void read_lumped_masses(const Values &body, BodyDefinition &definition) {
  const std::vector<std::string> masses = body.instances("Mass");
  for (const std::string &name : masses)
    definition.masses.push_back(read_mass(body.instance("Mass", name), name));
  if (masses.empty()) // which is the mistake to name
    return;
  for (const std::string &name : body.instances("Point"))
    definition.lumped_points.push_back(
        read_lumped_point(body.instance("Point", name), name, masses));
}

} // namespace vibroimpact::reduction
