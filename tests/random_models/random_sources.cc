#include "random_models/random_sources.h"

#include "random_models/random_model.h"

namespace vibroimpact::testing {

namespace {

struct Type {
  const char *name;
  const char *unit;
  double low, high; ///< exponents of the amplitude
};

constexpr Type types[] = {{"base acceleration", "m/s^2", -1, 1.3},
                          {"base displacement", "m", -3, -1},
                          {"base velocity", "m/s", -2, 0},
                          {"force", "N", -1, 1.5}};

std::string harmonic(Draw &draw, double frequency) {
  return set("Frequency", frequency, "rad/s") +
         set("Phase", draw.of({"0", "90", "217.3", "289.9059"}) + std::string(" deg"));
}

std::string history(Draw &draw, const Type &type, double frequency, double duration) {
  const bool displacement = type.name == std::string("base displacement");
  const std::string amplitude = set("Amplitude", draw.power(type.low, type.high), type.unit);
  const double kind = draw.uniform(0, 1);
  if (kind < 0.6)
    return amplitude + harmonic(draw, frequency);
  if (kind < 0.7)
    return set("History", "ramped harmonic") + amplitude + harmonic(draw, frequency) +
           subsection("Ramp", set("Rate", digits(draw.power(-1, 1)) + "/s"));
  if (kind < 0.8)
    return set("History", "sine sweep") + amplitude +
           subsection("Sine sweep", set("From", frequency, "rad/s") +
                                        set("To", frequency * draw.uniform(1.1, 3), "rad/s") +
                                        set("Duration", duration * draw.uniform(0.5, 1), "s"));
  if (kind < 0.9)
    return set("History", "impulse") + amplitude +
           subsection("Impulse", set("Shape", displacement ? "versed sine"
                                                           : draw.of({"half sine", "triangular",
                                                                      "versed sine"})) +
                                     set("Start", duration * draw.of({0.0, 0.2}), "s") +
                                     set("Duration", duration * draw.uniform(0.05, 0.5), "s"));
  if (kind < 0.95 && type.name == std::string("force"))
    return set("History", "constant") + amplitude;
  return set("History", "recorded") +
         subsection("Recorded", set("File", record_name) +
                                    set("Scale factor", draw.power(type.low, type.high)) +
                                    set("Unit", type.unit) + set("Interpolation", "cubic spline"));
}

} // namespace

std::string random_sources(Draw &draw, const RandomBodies &bodies, double frequency,
                           double duration) {
  std::string text;
  const int n = draw.of({1, 1, 1, 2});
  for (int i = 0; i < n; ++i) {
    const Type &type = types[draw.below(std::size(types))];
    std::string content = set("Type", type.name) + set("Direction", bodies.pushed);
    if (type.name == std::string("force"))
      content += set("At", draw.of(bodies.points));
    content += history(draw, type, i == 0 ? frequency : draw.uniform(1, 25), duration);
    text += subsection("Excitation e" + std::to_string(i), content);
  }
  if (draw.chance(0.35))
    text += subsection("Excitation g", set("Type", "gravity") +
                                           set("Direction", draw.of({"", "-"}) + bodies.pushed) +
                                           set("Amplitude", "9.81 m/s^2"));
  return text;
}

} // namespace vibroimpact::testing
