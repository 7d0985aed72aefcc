#include "random_models/random_bodies.h"

namespace vibroimpact::testing {

namespace {

void add_points(const std::vector<std::string> &points, bool held, RandomBodies &bodies) {
  bodies.points.insert(bodies.points.end(), points.begin(), points.end());
  if (held)
    bodies.held.insert(bodies.held.end(), points.begin(), points.end());
}

// Masses with springs and dashpots to the base; now and then one without, which is free.
void add_masses(Draw &draw, std::size_t n, double factor, RandomBodies &bodies) {
  std::string content = set("Type", "lumped");
  bool any_free = false;
  std::vector<std::string> points;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string name = "m" + std::to_string(i);
    const bool free = draw.chance(0.15);
    std::string mass = set("Mass", draw.power(-1, 1) * (i == 0 ? factor : 1), "kg") +
                       set("Axis", bodies.direction);
    if (!free)
      mass +=
          set("Stiffness", draw.power(0, 3), "N/m") + set("Damping", draw.power(-3, 0.5), "N s/m");
    content += subsection("Mass " + name, mass);
    any_free = any_free || free;
    points.push_back("b." + name);
  }
  add_points(points, !any_free, bodies);
  bodies.text += subsection("Body b", content);
}

std::string material(double density) {
  return subsection("Material", set("Young modulus", "70 GPa") + set("Density", density, "kg/m^3"));
}

std::string modes(Draw &draw, std::size_t fewest, std::size_t most) {
  return subsection("Modes", set("Number", std::to_string(fewest + draw.below(most - fewest + 1))) +
                                 set("Damping ratio", draw.power(-3, -1)));
}

// A slender beam along x, clamped at one or both ends or free to move across.
void add_beam(Draw &draw, double factor, RandomBodies &bodies) {
  const double length = draw.uniform(0.5, 2);
  const int kind = draw.of({0, 0, 0, 1, 2});
  std::string content = set("Type", "beam");
  content +=
      subsection("Geometry", set("Line", "0 m, 0 m, 0 m -> " + digits(length) + " m, 0 m, 0 m") +
                                 set("Elements", std::to_string(4 + 2 * draw.below(2))));
  content +=
      subsection("Section", set("Width", "20 mm") + set("Thickness", draw.uniform(1, 6), "mm"));
  content += material(2700 * factor) + modes(draw, kind == 2 ? 3 : 1, 5);
  content += subsection("Support plane", set("At", "all") + set("Fix", "x, y, rx, rz"));
  if (kind < 2)
    content += subsection("Support left", set("At", "start") + set("Fix", "all"));
  if (kind == 1)
    content += subsection("Support right", set("At", "end") + set("Fix", "all"));
  const std::string middle = digits(length / 2) + " m, 0 m, 0 m";
  content += subsection("Point middle",
                        set("Near", middle) +
                            (draw.chance(0.5) ? set("Mass", draw.power(-2, 0), "kg") : ""));
  if (kind != 1)
    content += subsection("Point tip", set("At", "end"));
  add_points(kind == 1 ? std::vector<std::string>{"beam.middle"}
                       : std::vector<std::string>{"beam.middle", "beam.tip"},
             kind < 2, bodies);
  bodies.text += subsection("Body beam", content);
}

// A thin plate in the plane z = 0, held along all edges or one.
void add_plate(Draw &draw, double factor, RandomBodies &bodies) {
  std::string content = set("Type", "shell");
  content +=
      subsection("Geometry", set("Plate", "0 m, 0 m, 0 m -> 0.6 m, 0 m, 0 m -> 0 m, 0.4 m, 0 m") +
                                 set("Divisions", draw.of({"4, 4", "6, 4"})) +
                                 set("Cell shape", draw.of({"quadrilateral", "triangle"})));
  content += material(2700 * factor) + modes(draw, 1, 4);
  content += subsection("Shell sheet", set("Thickness", draw.uniform(0.5, 4), "mm"));
  content += subsection("Support plane", set("At", "all") + set("Fix", "x, y, rz"));
  const bool edges = draw.chance(0.5);
  const bool clamped = draw.chance(0.5);
  content += subsection("Support edge", set("At", edges ? "edges" : "left") +
                                            set("Fix", clamped ? "z, rx, ry" : "z"));
  content += subsection("Point middle", set("Near", "0.3 m, 0.2 m, 0 m"));
  content += subsection("Point corner", set("Near", "0.45 m, 0.3 m, 0 m"));
  add_points({"plate.middle", "plate.corner"}, edges || clamped, bodies);
  bodies.text += subsection("Body plate", content);
}

void add_connections(Draw &draw, RandomBodies &bodies) {
  for (std::size_t i = 0; i + 1 < bodies.points.size(); ++i) {
    if (draw.chance(0.3))
      continue;
    std::string content = set("Between", bodies.points[i] + ", " + bodies.points[i + 1]) +
                          set("Direction", bodies.direction) +
                          set("Stiffness", draw.power(0, 3), "N/m") +
                          set("Damping", draw.power(-3, 0), "N s/m");
    if (draw.chance(0.15))
      content += set("Cubic stiffness", draw.power(0, 5), "N/m^3");
    bodies.text += subsection("Connection c" + std::to_string(i), content);
  }
}

} // namespace

RandomBodies random_bodies(Draw &draw, double factor) {
  RandomBodies bodies;
  const double kind = draw.uniform(0, 1);
  bodies.direction = kind < 0.7 ? "x" : "z";
  if (kind >= 0.7)
    kind < 0.9 ? add_beam(draw, factor, bodies) : add_plate(draw, factor, bodies);
  if (kind < 0.7 || draw.chance(0.3))
    add_masses(draw, kind < 0.7 ? draw.of({1, 1, 2, 3}) : 1, kind < 0.7 ? factor : 1, bodies);
  add_connections(draw, bodies);
  bodies.pushed = bodies.direction;
  return bodies;
}

} // namespace vibroimpact::testing
