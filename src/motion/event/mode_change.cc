#include "motion/event/mode_change.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vibroimpact::motion {

using contact::Guard;
using contact::LocalState;

namespace {

ConstVectorView view_of(const Vector &state) { return {state.data(), state.size()}; }

// From a local state whose internal states are of another vector.
void reset(const Equations &equations, std::size_t contact, const Guard &guard,
           const LocalState &before, Vector &state) {
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  double *const internal = state.data() + equations.layout().internal() + pair.internal_offset;
  pair.law->leave(equations.modes()[contact], before,
                  {internal, static_cast<std::size_t>(pair.n_internal())});
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

// The slip accelerations of sides that are to stick, where what else is held makes them slide all
// the same: one rests on what is moved. None: they can stick, as what is held independently can.
std::optional<LocalState> imposed_slip(const Equations &equations, std::size_t contact, double time,
                                       const Vector &state) {
  const int directions = equations.contacts().pairs()[contact].n_directions();
  const ActiveConstraints &holding = equations.holding();
  constexpr double least_pivot = 1e-10; // rows that are the same leave 1e-15
  if (holding.size() < directions ||
      PivotedQr(holding.rows() * holding.response(), least_pivot).rank() == holding.size())
    return std::nullopt;
  constexpr double roundings = 1e4; // what constraints that can be held leave is far less
  const StateLayout &layout = equations.layout();
  Vector rates(layout.size());
  equations.rates(time, view_of(state), {rates.data(), rates.size()});
  LocalState slides;
  bool found = false;
  for (int d = 1; d < directions; ++d) {
    const double rate = equations.gap_acceleration(contact, time, view_of(state),
                                                   {rates.data() + layout.velocity(), layout.n}, d);
    if (std::abs(rate) <= roundings * equations.acceleration_rounding(contact, time, state, d))
      continue;
    slides.tangential[static_cast<std::size_t>(d - 1)].slip_rate = rate;
    found = true;
  }
  return found ? std::optional(slides) : std::nullopt;
}

// From stick into the slip that is imposed. Along two directions it begins as where the force of
// stick, against that slip, has reached its limit: from no speed in a direction that is kept.
void slide_along(Equations &equations, std::size_t contact, const LocalState &slides, double time,
                 Vector &state) {
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  if (pair.tangential.size() < 2)
    return equations.set_mode(contact, pair.law->mode_by_slip(equations.modes()[contact], slides));
  LocalState at_limit = equations.local_state(contact, time, view_of(state));
  for (std::size_t d = 0; d < pair.tangential.size(); ++d)
    at_limit.tangential[d].force = -slides.tangential[d].slip_rate;
  const std::vector<Guard> &guards = equations.mode(contact).guards;
  const auto yields = std::ranges::find_if(guards, [&](const Guard &guard) {
    return pair.law->modes()[static_cast<std::size_t>(guard.target)].friction ==
           contact::Friction::slip;
  });
  const std::vector<double> internal(at_limit.internal.begin(), at_limit.internal.end());
  at_limit.internal = internal; // the state changes below
  const int target = yields->target;
  reset(equations, contact, *yields, at_limit, state);
  equations.set_mode(contact, target);
}

// Each mode is entered once at most; a law whose guards contradict each other stays where it is.
bool stick_or_slip(Equations &equations, std::size_t contact, double time, Vector &state) {
  const std::size_t most = equations.contacts().pairs()[contact].law->modes().size();
  bool changed = false;
  for (std::size_t i = 0; i < most && equations.mode(contact).holds_slip; ++i) {
    equations.stop_slip(time, state);
    if (const auto slides = imposed_slip(equations, contact, time, state)) {
      slide_along(equations, contact, *slides, time, state);
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

// What rounding leaves of slip rates.
double slip_rounding(const Equations &equations, std::size_t contact, double time,
                     const Vector &state) {
  double largest = 0;
  for (int d = 1; d < equations.contacts().pairs()[contact].n_directions(); ++d)
    largest = std::max(
        largest, equations.rounding(contact, contact::AffineForm::rate_along(d), time, state));
  return largest;
}

bool slides(const LocalState &local) {
  return std::any_of(local.tangential.begin(), local.tangential.end(),
                     [](const contact::TangentialState &of) { return of.slip_rate != 0; });
}

bool has_friction(const Equations &equations, std::size_t contact) {
  return !equations.contacts().pairs()[contact].tangential.empty();
}

// Along two directions: the mode in which sides stick that slip at no speed, far below that at
// which the direction of slip no longer counts; none: they do not.
std::optional<int> stick_at_rest(const Equations &equations, std::size_t contact, double time,
                                 const Vector &state) {
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  if (pair.tangential.size() < 2 || equations.mode(contact).friction != contact::Friction::slip)
    return std::nullopt;
  constexpr double far_below = 1e-3;
  const double slow = equations.local_state(contact, time, view_of(state)).slow_slip;
  const LocalState local = sliding_state(equations, contact, time, state, far_below * slow);
  const int mode = pair.law->mode_by_slip(equations.modes()[contact], local);
  if (slides(local) || !pair.law->modes()[static_cast<std::size_t>(mode)].holds_slip)
    return std::nullopt;
  return mode;
}

// Sides that one contact holds may be those of others too, whose slip has then stopped with its
// own: they stick as well, before it is asked which of them can.
void stop_beside(Equations &equations, std::size_t contact, double time, Vector &state) {
  std::vector<std::size_t> stopped = {contact};
  if (equations.contacts().has_planes())
    equations.stop_slip(time, state);
  for (std::size_t c = 0; c < equations.contacts().size(); ++c)
    if (const std::optional<int> mode = stick_at_rest(equations, c, time, state)) {
      equations.set_mode(c, *mode);
      stopped.push_back(c);
    }
  for (const std::size_t c : stopped)
    stick_or_slip(equations, c, time, state);
}

} // namespace

void pass_guard(Equations &equations, std::size_t contact, const Guard &guard, double time,
                const LocalState &before, Vector &state) {
  reset(equations, contact, guard, before, state);
  int target = guard.target;
  if (guard.by_slip)
    target = equations.contacts().pairs()[contact].law->mode_by_slip(
        target, sliding_state(equations, contact, time, state,
                              slip_rounding(equations, contact, time, state)));
  equations.set_mode(contact, target);
  if (has_friction(equations, contact) && equations.mode(contact).holds_slip)
    stop_beside(equations, contact, time, state);
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
