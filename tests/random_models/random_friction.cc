#include "random_models/random_friction.h"

#include <algorithm>

namespace vibroimpact::testing {

namespace {

// A direction of the plane in which the bodies move.
std::string oblique(Draw &draw, const RandomBodies &bodies) {
  const std::string share = digits(draw.uniform(0.2, 2));
  return bodies.direction == "x" ? "1, " + share + ", 0" : share + ", 0, 1";
}

void add_sliding_masses(Draw &draw, std::size_t n, double factor, RandomBodies &bodies) {
  std::string content = set("Type", "lumped");
  bool any_free = false;
  std::vector<std::string> points;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string name = "m" + std::to_string(i);
    const bool both = draw.chance(0.6);
    const bool free = draw.chance(0.2);
    std::string mass = set("Mass", draw.power(-1, 1) * (i == 0 ? factor : 1), "kg") +
                       set("Axis", bodies.direction + (both ? ", " + bodies.across : ""));
    if (!free)
      mass +=
          set("Stiffness", draw.power(0, 3), "N/m") + set("Damping", draw.power(-3, 0.5), "N s/m");
    content += subsection("Mass " + name, mass);
    any_free = any_free || free;
    points.push_back("b." + name);
    if (both)
      bodies.crossing.push_back(points.back());
  }
  bodies.points.insert(bodies.points.end(), points.begin(), points.end());
  if (!any_free)
    bodies.held.insert(bodies.held.end(), points.begin(), points.end());
  bodies.text += subsection("Body b", content);
}

// Clamped, along x; it bends in the plane of x and z.
void add_offset_beam(Draw &draw, double factor, RandomBodies &bodies) {
  const double length = draw.uniform(0.5, 2);
  const std::string section = set("Width", "20 mm") + set("Thickness", draw.uniform(1, 6), "mm");
  const std::string end = digits(length) + " m, 0 m, 0 m";
  std::string content = set("Type", "beam");
  content += subsection("Geometry", set("Line", "0 m, 0 m, 0 m -> " + end) + set("Elements", "6"));
  content += subsection("Section", section);
  content += subsection("Member all",
                        section + set("Offset", "0 mm, " + digits(draw.uniform(-40, 40)) + " mm"));
  content += subsection("Material",
                        set("Young modulus", "70 GPa") + set("Density", 2700 * factor, "kg/m^3"));
  content += subsection("Modes", set("Number", std::to_string(1 + draw.below(4))) +
                                     set("Damping ratio", draw.power(-3, -1)));
  content += subsection("Support plane", set("At", "all") + set("Fix", "y, rx, rz"));
  content += subsection("Support left", set("At", "start") + set("Fix", "all"));
  content += subsection("Point middle", set("Near", digits(length / 2) + " m, 0 m, 0 m"));
  content += subsection("Point tip", set("At", "end"));
  for (const char *point : {"beam.middle", "beam.tip"})
    for (auto *list : {&bodies.points, &bodies.held, &bodies.crossing})
      list->emplace_back(point);
  bodies.text += subsection("Body beam", content);
}

void add_springs(Draw &draw, RandomBodies &bodies) {
  for (std::size_t i = 0; i + 1 < bodies.points.size(); ++i)
    if (draw.chance(0.7))
      bodies.text += subsection(
          "Connection c" + std::to_string(i),
          set("Between", bodies.points[i] + ", " + bodies.points[i + 1]) +
              set("Direction", draw.chance(0.7) ? bodies.direction : oblique(draw, bodies)) +
              set("Stiffness", draw.power(0, 3), "N/m") +
              set("Damping", draw.power(-3, 0), "N s/m"));
}

// A dashpot beside the spring where the normal force is damped.
std::string spring_slider(Draw &draw, bool damped) {
  std::string content =
      set("Stiffness", draw.power(1, 5), "N/m") + set("Coefficient", draw.power(-1.3, 0));
  if (damped || draw.chance(0.3))
    content += set("Damping constant", draw.power(-1, 1.5), "N s/m");
  return set("Law", "spring-slider") + subsection("Spring-slider", content);
}

std::string coulomb(Draw &draw) {
  const double coefficient = draw.power(-1.3, 0);
  std::string content = set("Coefficient", coefficient);
  if (draw.chance(0.5))
    content += set("Static coefficient", coefficient * draw.uniform(1, 2));
  return set("Law", "coulomb") + subsection("Coulomb", content);
}

std::string friction(Draw &draw, const std::string &direction, bool damped) {
  const double kind = draw.uniform(0, 1);
  std::string content = set("Direction", direction);
  if (draw.chance(0.3))
    content += set("Surface speed", draw.of({-1.0, 1.0}) * draw.power(-2, 0), "m/s");
  content += kind < 0.5 ? coulomb(draw)
             : kind < 0.85
                 ? spring_slider(draw, damped)
                 : set("Law", "viscous") +
                       subsection("Viscous", set("Damping constant", draw.power(-1, 1.5), "N s/m"));
  return subsection("Friction", content);
}

// Pressed on each other across the plane of the motion.
std::string element(Draw &draw, const RandomBodies &bodies, bool crossing) {
  const std::string normal = bodies.direction == "x" ? "z" : "y";
  const std::string along = !crossing || draw.chance(0.5) ? bodies.direction
                            : draw.chance(0.5)            ? bodies.across
                                                          : oblique(draw, bodies);
  return set("Direction", normal) + set("Law", "constant force") +
         subsection("Constant force", set("Force", draw.power(-1, 1.5), "N")) +
         friction(draw, along, false);
}

// Rigid sides, which may bounce; their friction is Coulomb's.
std::string rubbing(Draw &draw, const RandomBodies &bodies, double gap, bool opposed) {
  const std::string law = set("Restitution coefficient", draw.of({0.0, 0.3, 0.7, 0.9})) +
                          set("Hypothesis", draw.of({"energetic", "newton", "poisson"}));
  const std::string along =
      draw.chance(0.3) ? set("Surface speed", draw.of({-1.0, 1.0}) * draw.power(-2, 0), "m/s") : "";
  return set("Direction", (opposed ? "-" : "") + bodies.direction) + set("Clearance", gap, "m") +
         set("Law", "newton restitution") + subsection("Newton restitution", law) +
         subsection("Friction", set("Direction", bodies.across) + along + coulomb(draw));
}

std::string parting(Draw &draw, const RandomBodies &bodies, double gap, bool opposed) {
  const std::size_t law = draw.below(3);
  const char *names[] = {"linear penalty", "kelvin-voigt", "kelvin-voigt bumper"};
  const char *sections[] = {"Linear penalty", "Kelvin-Voigt", "Kelvin-Voigt bumper"};
  std::string content = set("Stiffness", draw.power(1, 5), "N/m");
  if (law > 0)
    content += set("Damping constant", draw.power(-1, law == 1 ? 1 : 2), "N s/m");
  return set("Direction", (opposed ? "-" : "") + bodies.direction) + set("Clearance", gap, "m") +
         set("Initial penetration", "accept") + (gap < 0 ? set("Prestressed", "true") : "") +
         set("Law", names[law]) + subsection(sections[law], content) +
         friction(draw, bodies.across, law > 0);
}

bool among(const std::string &name, const std::vector<std::string> &list) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

} // namespace

RandomBodies random_sliding_bodies(Draw &draw, double factor) {
  RandomBodies bodies;
  const bool beam = draw.chance(0.25);
  bodies.direction = beam ? "z" : "x";
  bodies.across = beam ? "x" : "y";
  if (beam)
    add_offset_beam(draw, factor, bodies);
  if (!beam || draw.chance(0.3))
    add_sliding_masses(draw, beam ? 1 : draw.of({1, 1, 2, 3}), beam ? 1 : factor, bodies);
  add_springs(draw, bodies);
  bodies.pushed = draw.chance(0.5) ? oblique(draw, bodies) : bodies.direction;
  return bodies;
}

RandomContacts random_friction(Draw &draw, const RandomBodies &bodies, bool rigid) {
  RandomContacts contacts;
  if (draw.chance(0.25))
    contacts = random_contacts(draw, bodies);
  const std::size_t n = draw.of({1, 1, 2, 3});
  for (std::size_t j = 0; j < n; ++j) {
    const std::string a = draw.of(bodies.points);
    std::vector<std::string> others = {"stop", "stop", "base"};
    if (rigid) // a base that starts away from zero leaves no sides overlapping
      others = {"base", "base"};
    for (const std::string &point : bodies.points)
      if (point != a)
        others.push_back(point);
    const std::string b = draw.of(others);
    const bool crossing = among(a, bodies.crossing);
    const bool opposed = draw.chance(0.5);
    const double gap = random_clearance(draw, rigid);
    const bool parts = crossing && draw.chance(0.6);
    contacts.text += subsection("Contact f" + std::to_string(j),
                                set("Between", a + ", " + b) +
                                    (parts && rigid ? rubbing(draw, bodies, gap, opposed)
                                     : parts        ? parting(draw, bodies, gap, opposed)
                                                    : element(draw, bodies, crossing)));
    if (parts && (b == "stop" || b == "base") && !(rigid && !contacts.stop.empty())) {
      contacts.stop = a;
      contacts.onset = opposed ? -gap : gap;
    }
  }
  return contacts;
}

} // namespace vibroimpact::testing
