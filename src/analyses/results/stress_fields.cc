#include "analyses/results/stress_fields.h"

#include "analyses/results/fields.h"
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
        surface ? recovery.cell_stress : recovery.line_stress, coordinates);
    if (envelope.place >= 0 && envelope.maximum() > largest.value)
      largest = {.value = envelope.maximum(),
                 .instant = envelope.instant,
                 .place = reduction::place_of_stress(recovery, surface, envelope.place)};
  }
  return largest;
}

void add_body(const FieldWriter &result, const std::string &name, const LargestStress &largest,
              double time) {
  const FieldWriter of = result.below("body/" + name + "/von_mises_stress/").listed();
  of.number("maximum", largest.value, "Pa",
            "largest von Mises stress of all elements at the instants");
  of.number("time", time, "s", "instant of the largest von Mises stress");
  for (int axis = 0; axis < 3; ++axis)
    of.number(std::string(1, static_cast<char>('x' + axis)), largest.place[axis], "m",
              "place of the largest von Mises stress, undeformed");
}

bool has_stress(const reduction::ReducedBody &body) {
  return !body.recovery.line_stress.empty() || !body.recovery.cell_stress.empty();
}

} // namespace

void add_largest_stresses(const FieldWriter &result, const model::Model &model,
                          const Motion &motion) {
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
