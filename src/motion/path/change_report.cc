#include "motion/path/change_report.h"

namespace vibroimpact::motion {

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
                   .state = &state,
                   .before = &change.before,
                   .guard = &mode.guards[change.guard],
                   .layout = &layout});
}

} // namespace vibroimpact::motion
