#include "motion/event/mode_change.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

using contact::Guard;
using contact::LocalState;

namespace {

ConstVectorView view_of(const Vector &state) { return {state.data(), state.size()}; }

// From a local state whose internal states are of another vector.
void reset(const Equations &equations, std::size_t contact, const Guard &guard,
           const LocalState &before, Vector &state) {
  double *const internal = state.data() + equations.layout().internal() +
                           equations.contacts().pairs()[contact].internal_offset;
  for (std::size_t i = 0; i < guard.reset.size(); ++i)
    internal[i] = guard.reset[i](before);
}

// The guard by which sides that are to stick slip: it is below zero by more than rounding. Whether
// they part is not asked here; a gap that has just closed is nothing but rounding.
const Guard *no_stick(const Equations &equations, std::size_t contact, double time,
                      const Vector &state) {
  const LocalState local = equations.local_state(contact, time, view_of(state));
  const std::vector<Guard> &guards = equations.mode(contact).guards;
  const std::vector<contact::Mode> &modes = equations.contacts().pairs()[contact].law->modes();
  const auto fallen = std::find_if(guards.begin(), guards.end(), [&](const Guard &guard) {
    return modes[static_cast<std::size_t>(guard.target)].friction == contact::Friction::slip &&
           guard.indicator(local) < -equations.rounding(contact, guard.indicator, time, state);
  });
  return fallen == guards.end() ? nullptr : &*fallen;
}

// The slip acceleration of sides that are to stick, where what else is held makes them slide all
// the same: one rests on what is moved. Zero: they can stick, as what is held independently can.
double imposed_slip(const Equations &equations, std::size_t contact, double time,
                    const Vector &state) {
  const ActiveConstraints &holding = equations.holding();
  constexpr double least_pivot = 1e-10; // rows that are the same leave 1e-15
  if (holding.size() < 2 ||
      PivotedQr(holding.rows() * holding.response(), least_pivot).rank() == holding.size())
    return 0;
  constexpr double roundings = 1e4; // what constraints that can be held leave is far less
  const StateLayout &layout = equations.layout();
  Vector rates(layout.size());
  equations.rates(time, view_of(state), {rates.data(), rates.size()});
  const double slides = equations.gap_acceleration(contact, time, view_of(state),
                                                   {rates.data() + layout.velocity(), layout.n}, 1);
  return std::abs(slides) > roundings * equations.acceleration_rounding(contact, time, state, 1)
             ? slides
             : 0;
}

// Each mode is entered once at most; a law whose guards contradict each other stays where it is.
bool stick_or_slip(Equations &equations, std::size_t contact, double time, Vector &state) {
  const std::size_t most = equations.contacts().pairs()[contact].law->modes().size();
  bool changed = false;
  for (std::size_t i = 0; i < most && equations.mode(contact).holds_slip; ++i) {
    equations.stop_slip(time, state);
    if (const double slides = imposed_slip(equations, contact, time, state); slides != 0) {
      equations.set_mode(
          contact, equations.contacts().pairs()[contact].law->mode_by_slip(
                       equations.modes()[contact], {.tangential = {{{.slip_rate = slides}}}}));
      return true;
    }
    const Guard *const fallen = no_stick(equations, contact, time, state);
    if (!fallen)
      break;
    const Vector before = state;
    reset(equations, contact, *fallen, equations.local_state(contact, time, view_of(before)),
          state);
    equations.set_mode(contact, fallen->target);
    changed = true;
  }
  return changed;
}

// Slip rates that count as none are none.
LocalState sliding_state(const Equations &equations, std::size_t contact, double time,
                         const Vector &state, double slow) {
  LocalState local = equations.local_state(contact, time, view_of(state));
  for (contact::TangentialState &of : local.tangential)
    if (std::abs(of.slip_rate) <= slow)
      of.slip_rate = 0;
  return local;
}

bool slides(const LocalState &local) {
  return std::any_of(local.tangential.begin(), local.tangential.end(),
                     [](const contact::TangentialState &of) { return of.slip_rate != 0; });
}

bool has_friction(const Equations &equations, std::size_t contact) {
  return !equations.contacts().pairs()[contact].tangential.empty();
}

} // namespace

void pass_guard(Equations &equations, std::size_t contact, const Guard &guard, double time,
                const LocalState &before, Vector &state) {
  reset(equations, contact, guard, before, state);
  int target = guard.target;
  if (guard.by_slip)
    target = equations.contacts().pairs()[contact].law->mode_by_slip(
        target, sliding_state(
                    equations, contact, time, state,
                    equations.rounding(contact, contact::AffineForm::rate_along(1), time, state)));
  equations.set_mode(contact, target);
  if (has_friction(equations, contact))
    stick_or_slip(equations, contact, time, state);
}

void settle_friction(Equations &equations, const ContactScales &scales, double time,
                     Vector &state) {
  const std::size_t count = equations.contacts().size();
  for (std::size_t c = 0; c < count; ++c)
    if (has_friction(equations, c))
      equations.set_mode(
          c, equations.contacts().pairs()[c].law->mode_by_slip(
                 equations.modes()[c], sliding_state(equations, c, time, state, scales.speed(c))));
  // One that slips is a load on the others; each comes to slip once at most.
  bool changed = true;
  for (std::size_t i = 0; i <= count && changed; ++i) {
    changed = false;
    for (std::size_t c = 0; c < count; ++c)
      changed = (has_friction(equations, c) && stick_or_slip(equations, c, time, state)) || changed;
  }
}

void renew_friction(Equations &equations, const ContactScales &scales, double time, Vector &state) {
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (!has_friction(equations, c))
      continue;
    const LocalState local = sliding_state(equations, c, time, state, scales.speed(c));
    const contact::ContactLaw &law = *equations.contacts().pairs()[c].law;
    const int mode = law.mode_by_slip(equations.modes()[c], local);
    const bool stops = law.modes()[static_cast<std::size_t>(mode)].holds_slip;
    if (mode == equations.modes()[c] || (!slides(local) && !stops))
      continue;
    equations.set_mode(c, mode);
    if (stops)
      stick_or_slip(equations, c, time, state);
  }
}

} // namespace vibroimpact::motion
