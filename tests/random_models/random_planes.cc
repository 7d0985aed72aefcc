#include "random_models/random_planes.h"

#include <algorithm>

namespace vibroimpact::testing {

namespace {

std::string axes_of(bool in_space) { return in_space ? "x, y, z" : "x, y"; }

// A direction of the plane.
std::string slanted(Draw &draw) {
  return digits(draw.uniform(0.1, 1)) + ", " + digits(draw.uniform(-1, 1)) + ", 0";
}

std::string planar_coulomb(Draw &draw) {
  const double coefficient = draw.power(-1.3, 0);
  std::string content = set("Coefficient", coefficient);
  if (draw.chance(0.5))
    content += set("Static coefficient", coefficient * draw.uniform(1, 2));
  if (draw.chance(0.2))
    content += set("Damping constant", draw.power(-2, 0.5), "N s/m");
  return set("Law", "coulomb") + subsection("Coulomb", content);
}

std::string planar_slider(Draw &draw, bool damped) {
  std::string content =
      set("Stiffness", draw.power(1, 3.5), "N/m") + set("Coefficient", draw.power(-1.3, 0));
  if (damped || draw.chance(0.3))
    content += set("Damping constant", draw.power(-1, 1.5), "N s/m");
  return set("Law", "spring-slider") + subsection("Spring-slider", content);
}

std::string viscous(Draw &draw) {
  return set("Law", "viscous") +
         subsection("Viscous", set("Damping constant", draw.power(-1, 1.5), "N s/m"));
}

std::string moving_surface(Draw &draw) {
  return draw.chance(0.3) ? set("Surface speed", draw.of({-1.0, 1.0}) * draw.power(-2, 0), "m/s")
                          : "";
}

std::string along_two(Draw &draw, const std::string &direction, bool damped) {
  const double kind = draw.uniform(0, 1);
  return subsection("Friction", set("Directions", "two") + set("Direction", direction) +
                                    moving_surface(draw) +
                                    (kind < 0.6    ? planar_coulomb(draw)
                                     : kind < 0.85 ? planar_slider(draw, damped)
                                                   : viscous(draw)));
}

// Pressed on each other along z.
std::string pressed(Draw &draw) {
  return set("Direction", "z") + set("Law", "constant force") +
         subsection("Constant force", set("Force", draw.power(-1, 1.5), "N")) +
         along_two(draw, draw.chance(0.5) ? "x" : slanted(draw), false);
}

/// A law whose sides part.
struct Parting {
  std::string text;
  bool damped = false;
};

Parting penalty(Draw &draw, double stiffest) {
  const std::size_t law = draw.below(4);
  const char *names[] = {"linear penalty", "kelvin-voigt", "kelvin-voigt bumper", "hertz"};
  const char *sections[] = {"Linear penalty", "Kelvin-Voigt", "Kelvin-Voigt bumper", "Hertz"};
  std::string content = set("Stiffness", draw.power(1, stiffest), law == 3 ? "N/m^1.5" : "N/m");
  const bool damped = law == 1 || law == 2;
  if (damped)
    content += set("Damping constant", draw.power(-1, law == 1 ? 1 : 2), "N s/m");
  return {.text = set("Law", names[law]) + subsection(sections[law], content), .damped = damped};
}

// Of sides that may start in each other where nothing says how they came there.
std::string clearance(double gap) {
  return set("Clearance", gap, "m") + set("Initial penetration", "accept") +
         (gap < 0 ? set("Prestressed", "true") : "");
}

std::string landing(Draw &draw, double gap, bool opposed) {
  const Parting law = penalty(draw, 5);
  return set("Direction", opposed ? "-x" : "x") + clearance(gap) + law.text +
         along_two(draw, "y", law.damped);
}

Parting rigid_sides(Draw &draw) {
  return {.text = set("Law", "newton restitution") +
                  subsection("Newton restitution", set("Restitution coefficient",
                                                       draw.chance(0.2) ? 1 : draw.uniform(0, 1)))};
}

std::string rigid_coulomb(Draw &draw) {
  const double coefficient = draw.power(-2, 0);
  return set("Law", "coulomb") +
         subsection("Coulomb", set("Coefficient", coefficient) +
                                   (draw.chance(0.3) ? set("Static coefficient",
                                                           coefficient * draw.uniform(1, 2))
                                                     : ""));
}

// Coulomb's friction ends with a message where sides would stick that are not rigid.
std::string along_the_ring(Draw &draw, bool damped, bool rigid) {
  const double kind = draw.uniform(0, 1);
  if (kind < 0.3)
    return "";
  const std::string turning =
      draw.chance(0.5) ? set("Surface speed", draw.of({-1.0, 1.0}) * draw.power(-1, 0.5), "m/s")
                       : "";
  if (rigid)
    return subsection("Friction", turning + rigid_coulomb(draw));
  return subsection("Friction", turning + (kind < 0.75  ? planar_slider(draw, damped)
                                           : kind < 0.9 ? planar_coulomb(draw)
                                                        : viscous(draw)));
}

bool in_list(const std::string &name, const std::vector<std::string> &list) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// Rigid sides must not overlap at the start, where a base may be away from stops.
std::string other_side(Draw &draw, const std::string &one, const std::vector<std::string> &points,
                       bool rigid = false) {
  std::vector<std::string> others = {"stop", "stop", "base"};
  if (rigid)
    others = {"base", "base"};
  for (const std::string &point : points)
    if (point != one)
      others.push_back(point);
  return draw.of(others);
}

// "beside" leaves the way open along y: the second side is then far, as seen from above.
std::string around(Draw &draw, double gap, bool rigid) {
  const bool beside = draw.chance(0.25);
  const Parting law = rigid ? rigid_sides(draw) : penalty(draw, 5);
  std::string content = set("Gap", beside ? "beside" : "circle") + set("Axis", "z") +
                        set("Direction", "x") + set("Clearance", gap, "m") +
                        set("Initial penetration", "accept") + law.text;
  content += beside             ? set("Radii", draw.power(-1, 0), "m")
             : draw.chance(0.3) ? set("Eccentricity", gap * draw.uniform(-0.9, 0.9), "m")
                                : std::string();
  return content + along_the_ring(draw, law.damped, rigid);
}

} // namespace

RandomBodies random_planar_bodies(Draw &draw, double factor, bool in_space) {
  RandomBodies bodies;
  bodies.direction = "x";
  bodies.across = "y";
  std::string content = set("Type", "lumped");
  bool any_free = false;
  const std::size_t n = draw.of({1, 1, 2, 3});
  for (std::size_t i = 0; i < n; ++i) {
    const std::string name = "m" + std::to_string(i);
    const bool rises = in_space && draw.chance(0.5);
    const bool free = draw.chance(0.2);
    std::string mass =
        set("Mass", draw.power(-1, 1) * (i == 0 ? factor : 1), "kg") + set("Axis", axes_of(rises));
    if (!free)
      mass +=
          set("Stiffness", draw.power(0, 3), "N/m") + set("Damping", draw.power(-3, 0.5), "N s/m");
    content += subsection("Mass " + name, mass);
    any_free = any_free || free;
    bodies.points.push_back("b." + name);
    if (rises)
      bodies.crossing.push_back(bodies.points.back());
  }
  if (!any_free)
    bodies.held = bodies.points;
  bodies.text += subsection("Body b", content);
  for (std::size_t i = 0; i + 1 < n; ++i)
    if (draw.chance(0.7))
      bodies.text += subsection("Connection c" + std::to_string(i),
                                set("Between", bodies.points[i] + ", " + bodies.points[i + 1]) +
                                    set("Direction", draw.chance(0.5) ? "x" : slanted(draw)) +
                                    set("Stiffness", draw.power(0, 3), "N/m") +
                                    set("Damping", draw.power(-3, 0), "N s/m"));
  bodies.pushed = draw.chance(0.6) ? slanted(draw) : "x";
  return bodies;
}

RandomContacts random_planar_friction(Draw &draw, const RandomBodies &bodies) {
  RandomContacts contacts;
  const std::size_t n = draw.of({1, 1, 1, 2, 3});
  for (std::size_t j = 0; j < n; ++j) {
    const std::string a = draw.of(bodies.points);
    const std::string b = other_side(draw, a, bodies.points);
    const bool opposed = draw.chance(0.5);
    const double gap = random_clearance(draw, false);
    const bool lands = in_list(a, bodies.crossing) && draw.chance(0.7);
    contacts.text += subsection("Contact f" + std::to_string(j),
                                set("Between", a + ", " + b) +
                                    (lands ? landing(draw, gap, opposed) : pressed(draw)));
    if (lands && (b == "stop" || b == "base")) {
      contacts.stop = a;
      contacts.onset = opposed ? -gap : gap;
    }
  }
  return contacts;
}

RandomContacts random_rings(Draw &draw, const RandomBodies &bodies, bool rigid) {
  RandomContacts contacts;
  const std::size_t n = draw.of({1, 1, 1, 2});
  for (std::size_t j = 0; j < n; ++j) {
    const std::string a = draw.of(bodies.points);
    const std::string b = other_side(draw, a, bodies.points, rigid);
    const double gap = draw.chance(0.75) ? draw.power(-4, -1) : draw.power(-2, -1);
    contacts.text += subsection("Contact r" + std::to_string(j),
                                set("Between", a + ", " + b) + around(draw, gap, rigid));
    const bool nearest = !rigid || contacts.stop.empty() || gap < contacts.onset;
    if ((b == "stop" || b == "base") && nearest) {
      contacts.stop = a;
      contacts.onset = gap;
    }
  }
  return contacts;
}

} // namespace vibroimpact::testing
