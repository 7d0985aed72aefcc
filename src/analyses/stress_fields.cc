#include "analyses/stress_fields.h"

#include "analyses/fields.h"
#include "reduction/stress_envelope.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

using reduction::Recovery;
using reduction::StressEnvelope;

/// The largest value of a body.
struct LargestStress {
  double value = -1; ///< [Pa]
  Index instant = 0;
  Vector3 place = Vector3::Zero(); ///< [m]
};

LargestStress largest_stress(const Recovery &recovery, const Matrix &coordinates) {
  LargestStress largest;
  for (const bool surface : {false, true}) {
    const StressEnvelope envelope = reduction::stress_envelope(
        surface ? recovery.surface_stress : recovery.line_stress, coordinates);
    if (envelope.place >= 0 && envelope.maximum() > largest.value)
      largest = {.value = envelope.maximum(),
                 .instant = envelope.instant,
                 .place = reduction::place_of_stress(recovery, surface, envelope.place)};
  }
  return largest;
}

void add_body(PointResult &result, const std::string &name, const LargestStress &largest,
              double time) {
  const auto add = [&](const std::string &what, double value, const std::string &unit,
                       const std::string &description) {
    result.fields.push_back(
        scalar_field("body/" + name + "/von_mises_stress/" + what, value, unit, description));
    result.summary.push_back(
        scalar_line("body." + name + ".von_mises_stress." + what, value, unit));
  };
  add("maximum", largest.value, "Pa", "largest von Mises stress of all elements at the instants");
  add("time", time, "s", "instant of the largest von Mises stress");
  for (int axis = 0; axis < 3; ++axis)
    add(std::string(1, static_cast<char>('x' + axis)), largest.place[axis], "m",
        "place of the largest von Mises stress, undeformed");
}

bool has_stress(const reduction::ReducedBody &body) {
  return !body.recovery.line_stress.empty() || !body.recovery.surface_stress.empty();
}

} // namespace

void add_largest_stresses(PointResult &result, const model::Model &model, const Motion &motion) {
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    if (const reduction::ReducedBody &body = *model.bodies()[b]; has_stress(body)) {
      const LargestStress largest = largest_stress(body.recovery, motion.coordinates[b]);
      add_body(result, body.name, largest, motion.time[static_cast<std::size_t>(largest.instant)]);
    }
}

bool has_known_stress(const model::Model &model) {
  return std::any_of(model.bodies().begin(), model.bodies().end(),
                     [](const auto &body) { return has_stress(*body); });
}

} // namespace vibroimpact::analyses
