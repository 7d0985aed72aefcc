#include "random_models/random_contacts.h"

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

RandomContacts random_contacts(Draw &draw, const RandomBodies &bodies) {
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
    const Law &law = laws[draw.below(std::size(laws))];
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

} // namespace vibroimpact::testing
