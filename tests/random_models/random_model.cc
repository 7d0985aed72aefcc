#include "random_models/random_model.h"

#include "random_models/random_bodies.h"
#include "random_models/random_contacts.h"
#include "random_models/random_friction.h"
#include "random_models/random_planes.h"
#include "random_models/random_sources.h"

#include <algorithm>
#include <fstream>
#include <numbers>

namespace vibroimpact::testing {

namespace {

// At rest exactly where the first contact with a stop begins, or with a kick.
std::string initial_conditions(Draw &draw, const RandomContacts &contacts,
                               const RandomBodies &bodies) {
  if (draw.chance(0.6))
    return "";
  std::string content = set("Direction", bodies.direction);
  const bool held =
      std::find(bodies.held.begin(), bodies.held.end(), contacts.stop) != bodies.held.end();
  if (held && draw.chance(0.7))
    content += set("At", contacts.stop) + set("Displacement", contacts.onset, "m") +
               (draw.chance(0.3) ? set("Velocity", draw.uniform(-1, 1), "m/s") : "");
  else
    content += set("At", bodies.points.front()) + set("Shape", "mode") +
               set("Velocity", draw.power(-3, 0.5), "m/s");
  return subsection("Initial condition i", content);
}

RandomBodies bodies_of(Draw &draw, const ModelChoice &choice) {
  const double factor = 1 + choice.nudge;
  if (choice.seed >= first_with_written_laws)
    return random_bodies(draw, factor);
  if (choice.seed >= first_with_planar_friction)
    return random_planar_bodies(draw, factor, choice.seed < first_with_rings);
  return choice.seed >= first_with_friction ? random_sliding_bodies(draw, factor)
                                            : random_bodies(draw, factor);
}

RandomContacts contacts_of(Draw &draw, const ModelChoice &choice, const RandomBodies &bodies) {
  if (choice.seed >= first_with_written_laws) {
    RandomContacts contacts = random_contacts(draw, bodies, true);
    contacts.text += random_tensions(draw, bodies);
    return contacts;
  }
  if (choice.seed >= first_with_rings)
    return random_rings(draw, bodies, choice.seed >= first_with_rigid_rings);
  if (choice.seed >= first_with_planar_friction)
    return random_planar_friction(draw, bodies);
  return choice.seed >= first_with_friction
             ? random_friction(draw, bodies, choice.seed >= first_with_rigid_friction)
             : random_contacts(draw, bodies);
}

} // namespace

std::string random_model(const ModelChoice &choice) {
  Draw draw(choice.seed);
  const RandomBodies bodies = bodies_of(draw, choice);
  const RandomContacts contacts = contacts_of(draw, choice, bodies);
  const double frequency = draw.uniform(1, 25);
  const double duration = 2 * std::numbers::pi / frequency * draw.of({3.0, 6.0});
  std::string text = bodies.text + contacts.text;
  text += random_sources(draw, bodies, frequency, duration);
  text += initial_conditions(draw, contacts, bodies);
  text += subsection("Integration",
                     set("Relative tolerance", "1e-10") + set("Absolute tolerance", "1e-15 m"));
  text += subsection(
      "Analysis a", set("Type", "transient") +
                        subsection("Transient", set("Duration", duration, "s") +
                                                    set("Sampling interval", duration / 400, "s")));
  return text;
}

void write_record(const std::string &file) {
  std::ofstream stream(file);
  stream << "time, value\n";
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.05 * i;
    stream << digits(t) << ", "
           << digits(0.5 * std::sin(3.1 * t) + 0.3 * std::sin(7.7 * t + 1) +
                     0.2 * std::sin(17.3 * t + 2))
           << "\n";
  }
}

} // namespace vibroimpact::testing
