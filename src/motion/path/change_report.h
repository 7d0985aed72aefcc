// What observers are shown of a contact change, and what it takes from the energies.
#pragma once

#include "motion/interval/observer.h"
#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// A contact that has come from the mode `from` through one of its guards. The equations are in the
/// modes behind, and so is `state`; `before` is the state before, `local` the local state there.
struct PassedChange {
  double time = 0;
  std::size_t contact = 0;
  int from = 0;
  std::size_t guard = 0;
  contact::LocalState local;
  const Vector &before;
};

/// Shows it to the observers. Where the integrals are kept, what the new mode stores no more is
/// lost.
void report_change(const Equations &equations, const PassedChange &change, bool integrals,
                   Vector &state, const Observers &observers);

/// Where a contact in a circular gap touches, from a_1 [rad]; NaN in a plane gap.
double angle_of_contact(const Equations &equations, std::size_t contact, double time,
                        const Vector &state);

} // namespace vibroimpact::motion
