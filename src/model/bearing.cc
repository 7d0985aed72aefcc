#include "model/bearing.h"

#include "model/direction.h"
#include "model/side.h"

#include <cmath>

namespace vibroimpact::model {

namespace {

// Row by row.
Eigen::Matrix2d two_by_two(const parameters::Values &section, const std::string &key) {
  const std::vector<double> values = section.quantities(key);
  Eigen::Matrix2d matrix;
  matrix << values[0], values[1], values[2], values[3];
  return matrix;
}

std::array<Vector3, 2> read_directions(const parameters::Values &section) {
  section.require("First direction");
  section.require("Second direction");
  const Vector3 first = read_direction(section, "First direction");
  const Vector3 second = read_direction(section, "Second direction");
  constexpr double rounding = 1e-12;
  if (std::abs(first.dot(second)) > rounding)
    section.reject("Second direction", "must be at right angles to First direction");
  return {first, second};
}

Bearing read_bearing(const parameters::Values &section, const std::string &name,
                     const Model &model) {
  const Sides sides = read_sides(section, {side_base, side_ground}, model);
  if (!section.given("Stiffness") && !section.given("Damping"))
    section.reject_section(
        "Stiffness or Damping must be given; without one the bearing does nothing");
  Bearing bearing{.name = name,
                  .side_a = sides.a,
                  .side_b = sides.b,
                  .elongation = {},
                  .stiffness = two_by_two(section, "Stiffness"),
                  .damping = two_by_two(section, "Damping")};
  const std::array<Vector3, 2> directions = read_directions(section);
  for (std::size_t d = 0; d < directions.size(); ++d) {
    bearing.elongation[d] = relative_displacement(sides, directions[d], model);
    if (bearing.elongation[d].row.isZero(0))
      section.reject(d == 0 ? "First direction" : "Second direction",
                     "must be a direction along which at least one of the two sides can move");
  }
  return bearing;
}

} // namespace

void declare_bearings(parameters::Section &root) {
  using namespace parameters;
  root.named_subsection("Bearing",
                        "Springs and dashpots between two points along two directions, which they "
                        "may join, as films of oil do.")
      .names("Between", "",
             "The two ends as BODY.POINT; the second may be base (what the first body stands on, "
             "the default) or ground (fixed in space).")
      .required()
      .text("First direction", "", "Across the shaft: x, -y or three numbers.")
      .required()
      .text("Second direction", "", "Likewise, at right angles to the first.")
      .required()
      .quantities("Stiffness", "0 N/m, 0 N/m, 0 N/m, 0 N/m", dimension::stiffness, range::any, "K",
                  "k11, k12, k21, k22: force along the first number's direction per displacement "
                  "along the second's. k12 and k21 of opposite signs drive a whirl: with k12 > 0 > "
                  "k21 from the first direction to the second.",
                  4, 4)
      .quantities("Damping", "0 N s/m, 0 N s/m, 0 N s/m, 0 N s/m", dimension::damping, range::any,
                  "C", "c11, c12, c21, c22, likewise per velocity.", 4, 4);
}

void add_bearings(const parameters::Values &root, Model &model) {
  for (const std::string &name : root.instances("Bearing"))
    model.add_bearing(read_bearing(root.instance("Bearing", name), name, model));
}

} // namespace vibroimpact::model
