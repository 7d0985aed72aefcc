#include "random_models/random_contacts.h"

#include <algorithm>

namespace vibroimpact::testing {

namespace {

std::string spring(Draw &draw) { return set("Stiffness", draw.power(1, 6), "N/m"); }

std::string spring_and_dashpot(Draw &draw, double low, double high) {
  return spring(draw) + set("Damping constant", draw.power(low, high), "N s/m");
}

std::string hertz(Draw &draw, double high) {
  return set("Stiffness", draw.power(2, high), "N/m^1.5");
}

std::string hunt_crossley(Draw &draw) {
  std::string content = hertz(draw, 9);
  if (draw.chance(0.25))
    return content + set("Damping factor", draw.power(1, 6), "N s/m^2.5");
  content += set("Restitution coefficient", draw.uniform(0.2, 1));
  return content + (draw.chance(0.3) ? set("Approach speed", draw.power(-2, 0), "m/s") : "");
}

std::string tsuji(Draw &draw) {
  return hertz(draw, 8) + set("Damping coefficient", draw.uniform(0, 1.5)) +
         set("Effective mass", draw.power(-1, 1), "kg");
}

struct Law {
  const char *name;
  const char *section;
  std::string (*content)(Draw &draw);
};

const Law laws[] = {
    {"linear penalty", "Linear penalty", spring},
    {"kelvin-voigt", "Kelvin-Voigt", [](Draw &d) { return spring_and_dashpot(d, -2, 1); }},
    {"kelvin-voigt bumper", "Kelvin-Voigt bumper",
     [](Draw &d) { return spring_and_dashpot(d, -1, 3); }},
    {"bilinear stop", "Bilinear stop", [](Draw &d) { return spring_and_dashpot(d, -2, 1); }},
    {"hertz", "Hertz", [](Draw &d) { return hertz(d, 9); }},
    {"hunt-crossley", "Hunt-Crossley", hunt_crossley},
    {"tsuji", "Tsuji", tsuji},
    {"kuwabara-kono", "Kuwabara-Kono",
     [](Draw &d) { return hertz(d, 8) + set("Dissipation time", d.power(-5, -2), "s"); }},
    {"newton restitution", "Newton restitution",
     [](Draw &d) {
       return set("Restitution coefficient", d.of({0.0, 0.3, 0.7, 0.9, 1.0}));
     }},
};

// Convex or not; a stop that crushes unloads along a line that is steeper than all segments.
std::string table(Draw &draw) {
  const std::size_t n = 2 + draw.below(5);
  std::string penetrations = "0 m", forces = "0 N";
  double u = 0, force = 0, steepest = 0;
  for (std::size_t i = 1; i < n; ++i) {
    const double du = draw.power(-5, -2), slope = draw.power(1, 5);
    u += du;
    force += slope * du;
    steepest = std::max(steepest, slope);
    penetrations += ", " + digits(u) + " m";
    forces += ", " + digits(force) + " N";
  }
  std::string content = set("Penetration", penetrations) + set("Force", forces);
  if (draw.chance(0.4))
    content += set("Unloading stiffness", steepest * draw.uniform(1.1, 5), "N/m");
  else if (draw.chance(0.3))
    content += set("Damping constant", draw.power(-2, 1), "N s/m");
  return content;
}

std::string written_force(Draw &draw) {
  switch (draw.below(4)) {
  case 0:
    return set("Force", digits(draw.power(1, 5)) + "*x + " + digits(draw.power(3, 8)) + "*x^3");
  case 1:
    return set("Force",
               digits(draw.power(2, 6)) + "*x^1.5*(1 + " + digits(draw.power(-2, 0)) + "*v)") +
           set("Tension", "cut off");
  case 2:
    return set("Force", digits(draw.power(1, 5)) + "*x*(1 + " + digits(draw.power(-2, 0)) + "*v)") +
           set("Tension", "cut off");
  default:
    return set("Force",
               digits(draw.power(0, 3)) + "*(exp(" + digits(draw.power(0, 2)) + "*x) - 1)");
  }
}

const Law written_laws[] = {
    {"table", "Table", table},
    {"formula", "Formula",
     [](Draw &d) { return written_force(d) + set("Largest penetration", "0.5 m"); }},
};

const Law &drawn_law(Draw &draw, bool written) {
  return written ? written_laws[draw.below(std::size(written_laws))]
                 : laws[draw.below(std::size(laws))];
}

} // namespace

// Negative ones only where the sides may overlap.
double random_clearance(Draw &draw, bool rigid) {
  const double kind = draw.uniform(0, 1);
  if (kind < 0.35)
    return 0;
  if (kind < 0.45 && !rigid)
    return -draw.power(-5, -3);
  return kind < 0.75 ? draw.power(-4, -1) : draw.power(-2, -1);
}

RandomContacts random_contacts(Draw &draw, const RandomBodies &bodies, bool written) {
  RandomContacts contacts;
  const std::size_t n = draw.of({1, 1, 1, 2, 2, 3, 4});
  for (std::size_t j = 0; j < n; ++j) {
    const std::string a = draw.of(bodies.points);
    std::vector<std::string> others = {"stop", "stop", "base", "base"};
    for (const std::string &point : bodies.points)
      if (point != a)
        others.push_back(point);
    const std::string b = draw.of(others);
    const bool opposed = draw.chance(0.5);
    const Law &law = drawn_law(draw, written);
    const double gap = random_clearance(draw, law.name == std::string("newton restitution"));
    std::string content = set("Between", a + ", " + b) +
                          set("Direction", (opposed ? "-" : "") + bodies.direction) +
                          set("Clearance", gap, "m") + set("Initial penetration", "accept") +
                          (gap < 0 ? set("Prestressed", "true") : "") + set("Law", law.name) +
                          subsection(law.section, law.content(draw));
    contacts.text += subsection("Contact k" + std::to_string(j), content);
    if (b == "stop" || b == "base") {
      contacts.stop = a;
      contacts.onset = opposed ? -gap : gap;
    }
  }
  return contacts;
}

std::string random_tensions(Draw &draw, const RandomBodies &bodies) {
  std::string text;
  for (std::size_t j = draw.below(3); j > 0; --j) {
    const std::string ends = draw.of(bodies.points) + ", ground";
    std::string law;
    if (draw.chance(0.5)) {
      const double play = draw.power(-3, -1), k = draw.power(0, 3);
      const std::string e = digits(play) + " m", far = digits(3 * play) + " m";
      const std::string f = digits(2 * play * k) + " N";
      law = set("Law", "table") +
            subsection("Table", set("Elongation", "-" + far + ", -" + e + ", " + e + ", " + far) +
                                    set("Tension", "-" + f + ", 0 N, 0 N, " + f));
    } else {
      law = set("Law", "formula") +
            subsection("Formula", set("Tension", digits(draw.power(0, 3)) + "*x + " +
                                                     digits(draw.power(0, 5)) + "*x^3 + " +
                                                     digits(draw.power(-3, 0)) + "*v") +
                                      set("Largest elongation", "5 m"));
    }
    text += subsection("Connection w" + std::to_string(j),
                       set("Between", ends) + set("Direction", bodies.direction) + law);
  }
  return text;
}

} // namespace vibroimpact::testing
