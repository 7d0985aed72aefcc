#include "analyses/curves/mode_start.h"

#include "common/error.h"
#include "model/assembled_system.h"
#include "motion/system/equilibrium.h"
#include "periodic/forced_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

double smallest_gap(const System &system, const Vector &displacement) {
  double least = std::numeric_limits<double>::infinity();
  for (const contact::ContactPair &pair : system.contacts.pairs())
    if (!pair.circle)
      least = std::min(least, pair.gap.row.dot(displacement) + pair.clearance);
  return least;
}

// The whole motion passes below it, both ways.
void refuse_reached(const System &system, const ModeStart &start, const Vector &rest,
                    const Vector &way) {
  for (const contact::ContactPair &pair : system.contacts.pairs()) {
    const double gap = pair.clearance + pair.gap.row.dot(rest);
    const double share = std::abs(pair.gap.row.dot(way)) / gap;
    if (!pair.circle && gap > 0 && share >= 1)
      start.section.value().reject(
          "First energy", "must be less than " + std::to_string(start.energy / (share * share)) +
                              " J, at which the linear mode reaches the contact " + pair.name);
  }
}

Vector mode_state(const Vector &displacement, const Vector &velocity) {
  Vector state(displacement.size() + velocity.size());
  state << displacement, velocity;
  return state;
}

} // namespace

LinearMode linear_mode(const System &system, const ModeStart &start) {
  if (!periodic::is_autonomous(system.model))
    start.section.value().reject_section(
        "Excitations must not change with time: a nonlinear mode is a motion "
        "without them");
  if (system.model.has_circulatory_forces())
    start.section.value().reject_section(
        "a nonlinear mode must have no circulatory forces, which have no energy: a Bearing must "
        "have k12 = k21, and a body that turns no Internal damping");
  const model::AssembledModes modes =
      assembled_modes(system.model, model::AssembledSystem(system.model));
  const Index number = start.mode - 1;
  if (number >= modes.stiffness.size())
    start.section.value().reject("Mode", "must not be larger than the number of modes, " +
                                             std::to_string(modes.stiffness.size()));
  if (number < modes.rigid)
    start.section.value().reject("Mode",
                                 "must be larger than " + std::to_string(modes.rigid) +
                                     ", the number of rigid-body modes, which do not vibrate");
  const double omega = modes.angular_frequency()[number];
  const Vector velocity = modes.shapes.col(number) * std::sqrt(2 * start.energy);
  const Vector way = velocity / omega, still = Vector::Zero(velocity.size());
  const Vector rest =
      motion::static_equilibrium(system.model, system.contacts, system.model.static_load())
          .displacement;
  refuse_reached(system, start, rest, way);
  LinearMode mode{.period = 2 * std::numbers::pi / omega,
                  .rest = mode_state(rest, still),
                  .motion = mode_state(still, velocity)};
  if (!(smallest_gap(system, rest) > 0))
    mode.motion = mode_state(
        smallest_gap(system, rest - way) > smallest_gap(system, rest + way) ? -way : way, still);
  return mode;
}

} // namespace vibroimpact::analyses
