// Rigid contacts that last, where one of them changes: a slip stops, a stick breaks, or sides part.
//
// What one of them does acts on the others: feet of one body come to rest together. Which of them
// stick, slip and part from there on is one problem for the forces and accelerations of all
// (contact/frictional_impulses.h). The contact that changes does not go back: it is open where its
// force has ended, and slips where its stick has broken, as do others then that slip at no speed or
// whose stick breaks at the same instant.
#pragma once

#include "motion/event/contact_scales.h"
#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// Does this contact last beside others, and has one of them friction?
bool lasts_beside_others(const Equations &equations, std::size_t contact);

/// Passes a guard of such a contact: takes the equations to the modes of all that last, and what
/// is left of the slip rates of those that stick off the velocities.
void pass_together(Equations &equations, const ContactScales &scales, std::size_t contact,
                   const contact::Guard &guard, double time, Vector &state);

} // namespace vibroimpact::motion
