// How a motion begins: what is allowed, and in which modes the contacts are.
#include "motion/path/trajectory.h"

#include "common/error.h"

#include <algorithm>
#include <string>

namespace vibroimpact::motion {

void Trajectory::refuse_penetration(double time, const Vector &state) const {
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    if (pair.law->always_in_contact())
      continue;
    const contact::LocalState local =
        equations_.local_state(c, time, ConstVectorView(state.data(), state.size()));
    constexpr double digits_of_input = 1e-9;
    const double sizes = equations_.magnitude(c, {.gap = 1}, time, state) * digits_of_input;
    if (local.gap >= -std::max(sizes, settings_.absolute_tolerance))
      continue;
    if (pair.law->rigid())
      throw InputError(pair.origin + "\n  the motion starts with two rigid sides overlapping by " +
                       std::to_string(-local.gap * 1e3) +
                       " mm; change the initial condition or the clearance.");
    if (!pair.accept_initial_penetration)
      throw InputError(pair.origin + "\n  the motion starts with the two sides overlapping by " +
                       std::to_string(-local.gap * 1e3) +
                       " mm; change the initial condition or the clearance, or allow it with "
                       "Initial penetration = accept.");
  }
}

void Trajectory::choose_initial_modes(double time, const Vector &state) {
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const ConstVectorView x(state.data(), state.size());
    equations_.set_mode(
        c, equations_.contacts().pairs()[c].law->initial_mode(equations_.local_state(c, time, x)));
  }
}

// Contacts that are closed from the start take the internal states with which they would have been
// entered.
void Trajectory::enter_contacts(double time, Vector &state) const {
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const contact::ContactPair &pair = equations_.contacts().pairs()[c];
    const contact::LocalState local =
        equations_.local_state(c, time, ConstVectorView(state.data(), state.size()));
    const std::vector<double> entered = contact::settle(*pair.law, local).internal;
    std::copy(entered.begin(), entered.end(),
              state.data() + layout().internal() + pair.internal_offset);
  }
}

void Trajectory::start(double time, const Vector &displacement, const Vector &velocity) {
  equations_.set_source_break(equations_.model().next_break(time));
  MotionState from{.time = time, .physical = Vector::Zero(layout().physical_size())};
  from.physical.head(layout().n) = displacement;
  from.physical.segment(layout().velocity(), layout().n) = velocity;
  from.physical.segment(layout().internal(), layout().n_internal) =
      equations_.contacts().initial_internal();
  from.physical.tail(layout().n_drive) = equations_.model().rotors().initial_drive();
  Vector state = Vector::Zero(layout().size());
  state.head(layout().physical_size()) = from.physical;
  refuse_penetration(time, state);
  enter_contacts(time, state);
  from.physical = state.head(layout().physical_size());
  start(from);
}

} // namespace vibroimpact::motion
