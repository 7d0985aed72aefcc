// What a trajectory does where rigid contacts meet.
#include "motion/path/change_report.h"
#include "motion/path/trajectory.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {
// More impacts than that at one instant end all relative speeds of the contacts that touch.
constexpr long maximum_impacts_at_once = 50;
} // namespace

void Trajectory::collide(std::size_t first, const Observers &observers) {
  const Vector before = steppers_.present().state();
  Vector state = before;
  const std::vector<int> modes = equations_.modes();
  const contact::Guard &passed = *std::find_if(
      equations_.mode(first).guards.begin(), equations_.mode(first).guards.end(),
      [](const contact::Guard &guard) { return guard.action == contact::GuardAction::impact; });
  const Collisions::Outcome outcome = collisions_.resolve(
      time(), time_tolerance(), first, last_.events >= maximum_impacts_at_once, state);
  const Collision *record = &outcome.record;
  for (const Collisions::Change &change : outcome.changes) {
    observers.event({.time = time(),
                     .contact = change.contact,
                     .from = change.from,
                     .to = change.to,
                     .onset = change.onset,
                     .gap = change.gap,
                     .gap_rate = change.gap_rate,
                     .gap_rate_after = change.gap_rate_after,
                     .chatter_duration = change.chatter_duration,
                     .angle = angle_of_contact(equations_, change.contact, time(), before),
                     .state = &state,
                     .before = &before,
                     .guard = &passed,
                     .layout = &layout(),
                     .collision = record});
    record = nullptr;
    progress_.note(change.contact, time(), 0, time_tolerance());
    counts_.chatters += change.chatter_duration > 0 ? 1 : 0;
    if (change.gap_rate_after != change.gap_rate)
      last_.tried.clear();
  }
  counts_.reduced_restitutions += outcome.reduced;
  ++counts_.events;
  begin_phase(time(), state);
  std::erase_if(zero_at_start_, [&](const ZeroGuard &zero) { // guards of modes that are no more
    return equations_.modes()[zero.contact] != modes[zero.contact];
  });
  renew_zero_guards(state);
  for (std::size_t k = 0; k < outcome.touching.size(); ++k) {
    const std::size_t contact = outcome.touching[k];
    std::erase_if(zero_at_start_, [&](const ZeroGuard &zero) { return zero.contact == contact; });
    note_zero_guards(contact, {{.form = {.gap = 1}, .size = std::abs(outcome.gaps[k])}}, 0, state);
  }
  note_zero_guards(state);
}

} // namespace vibroimpact::motion
