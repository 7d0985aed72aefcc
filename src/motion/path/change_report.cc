#include "motion/path/change_report.h"

#include "common/scalar.h"

#include <cmath>

namespace vibroimpact::motion {

double angle_of_contact(const Equations &equations, std::size_t contact, double time,
                        const Vector &state) {
  if (!equations.contacts().pairs()[contact].circle)
    return nan;
  const contact::CircularFrame at =
      equations.frame(contact, time, ConstVectorView(state.data(), state.size()));
  return std::atan2(at.normal[1], at.normal[0]);
}

void report_change(const Equations &equations, const PassedChange &change, bool integrals,
                   Vector &state, const Observers &observers) {
  const contact::ContactPair &pair = equations.contacts().pairs()[change.contact];
  const StateLayout &layout = equations.layout();
  const int to = equations.modes()[change.contact];
  const contact::Mode &mode = pair.law->modes()[static_cast<std::size_t>(change.from)];
  if (integrals) {
    contact::LocalState behind = change.local;
    behind.internal = {state.data() + layout.internal() + pair.internal_offset,
                       behind.internal.size()};
    state[layout.contact_work(static_cast<Index>(change.contact))] +=
        equations.contact_energy(change.contact, change.from, change.local) -
        equations.contact_energy(change.contact, to, behind);
  }
  observers.event({.time = change.time,
                   .contact = change.contact,
                   .from = change.from,
                   .to = to,
                   .onset = !mode.in_contact && equations.mode(change.contact).in_contact,
                   .gap = change.local.gap,
                   .gap_rate = change.local.gap_rate,
                   .gap_rate_after = change.local.gap_rate,
                   .angle = angle_of_contact(equations, change.contact, change.time, change.before),
                   .state = &state,
                   .before = &change.before,
                   .guard = &mode.guards[change.guard],
                   .layout = &layout});
}

} // namespace vibroimpact::motion
