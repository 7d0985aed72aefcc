#include "model/connection.h"

#include "model/direction.h"

#include <algorithm>

namespace vibroimpact::model {

namespace {

constexpr parameters::Dimension cubic_stiffness{.length = -2, .mass = 1, .time = -2}; // N/m^3

// A swept spring or dashpot may be zero at an end.
void require_constant(const parameters::Values &section, bool rotation) {
  if (section.choice("Law") != "none")
    return;
  if (rotation && !section.given("Rotational stiffness") && !section.given("Rotational damping"))
    section.reject_section("Rotational stiffness or Rotational damping must be given; without one "
                           "the connection does nothing");
  if (!rotation && !section.given("Stiffness") && !section.given("Cubic stiffness") &&
      !section.given("Damping"))
    section.reject_section(
        "Stiffness, Cubic stiffness, Damping or a Law must be given; without one "
        "the connection does nothing");
}

Connection read_connection(const parameters::Values &root, const std::string &name,
                           const Model &model) {
  const parameters::Values section = root.instance("Connection", name);
  const Sides sides = read_sides(section, {side_base, side_ground}, model);
  const MotionAxis axis = read_motion_axis(section, "Direction");
  check_axis_keys(section, axis, {"Stiffness", "Cubic stiffness", "Damping"},
                  {"Rotational stiffness", "Rotational damping"});
  const Projection elongation = connection_elongation(root, name, sides, axis, model);
  if (elongation.row.isZero(0))
    section.reject(
        "Direction",
        "Direction must be a direction along which at least one of the two sides can move.");
  require_constant(section, axis.rotation);
  return {.name = name,
          .side_a = sides.a,
          .side_b = sides.b,
          .elongation = elongation,
          .stiffness = section.quantity(axis.rotation ? "Rotational stiffness" : "Stiffness"),
          .cubic_stiffness = section.quantity("Cubic stiffness"),
          .damping = section.quantity(axis.rotation ? "Rotational damping" : "Damping"),
          .rotation = axis.rotation};
}

} // namespace

bool joins_ground(const parameters::Values &connection) {
  const std::vector<std::string> ends = connection.names("Between");
  return ends.size() == 2 && ends[1] == side_ground &&
         !read_motion_axis(connection, "Direction").rotation;
}

Projection connection_elongation(const parameters::Values &root, const std::string &name,
                                 const Sides &sides, const MotionAxis &axis, const Model &model) {
  Projection elongation = relative_displacement(sides, axis, model);
  for (const std::string &excitation : root.instances("Excitation")) {
    const parameters::Values section = root.instance("Excitation", excitation);
    const std::vector<std::string> moved = section.names("Connections");
    const std::size_t source = model.find_source(excitation);
    if (source < model.sources().size() &&
        std::find(moved.begin(), moved.end(), name) != moved.end())
      elongation.base_coefficients[source] +=
          read_direction(section, "Direction").dot(axis.direction);
  }
  return elongation;
}

void declare_connections(parameters::Section &root) {
  using namespace parameters;
  root.named_subsection("Connection",
                        "A spring and a dashpot between two points, or a point and its base. With "
                        "Stiffness = 0 N/m alone it measures their relative motion.")
      .names("Between", "",
             "The two ends as BODY.POINT; the second may be base (what the first body stands on, "
             "the default) or ground (fixed in space, or moved by the Excitation whose Connections "
             "name this one).")
      .required()
      .text("Direction", "x",
            "Direction along which it acts: x, -y or three numbers; or rx, -ry and so on for the "
            "rotation about which it does.")
      .quantity("Stiffness", "0 N/m", dimension::stiffness, range::any, "k", "Linear part.")
      .quantity("Cubic stiffness", "0 N/m^3", cubic_stiffness, range::any, "k_3",
                "Factor of the cube of the elongation; negative softens.")
      .quantity("Damping", "0 N s/m", dimension::damping, range::non_negative, "c", "Dashpot.")
      .quantity("Rotational stiffness", "0 N m", dimension::rotational_stiffness, range::any,
                "k_\\theta", "Torque per relative rotation [N m/rad].")
      .quantity("Rotational damping", "0 N m s", dimension::rotational_damping, range::non_negative,
                "c_\\theta", "Torque per relative angular velocity.")
      .choice(
          "Law", "none", {"none", "table", "formula", "zener"},
          "A tension in addition to these, which the section Table, Formula or Zener gives. It is "
          "reported as the force of a contact that never opens, with the opposite sign.");
}

void add_connections(const parameters::Values &root, Model &model) {
  for (const std::string &name : root.instances("Connection"))
    model.add_connection(read_connection(root, name, model));
}

} // namespace vibroimpact::model
