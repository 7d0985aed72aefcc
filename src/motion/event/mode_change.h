// What a guard does to a contact, and which modes contacts with friction have at an instant.
//
// Velocities do not jump at a guard, but for the rounding that is left of a slip rate where two
// sides come to stick: it is taken off exactly, for its sign would decide the next slip. Whether
// they stick is decided by the force that this takes, never by a small slip rate: where it is more
// than friction gives, the slip goes on the other way at once, and the turn is one change.
#pragma once

#include "motion/event/contact_scales.h"
#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// Passes a guard of the contact's present mode: resets its internal states in `state`, and takes
/// the equations to the mode behind it. `before`: the local state there, its internal states those
/// of another vector than `state`.
void pass_guard(Equations &equations, std::size_t contact, const contact::Guard &guard, double time,
                const contact::LocalState &before, Vector &state);

/// The modes of all contacts with friction by their slip rates and the forces that would hold them,
/// where a motion begins; slip rates below ContactScales::speed() count as none.
void settle_friction(Equations &equations, const ContactScales &scales, double time, Vector &state);

/// The same where velocities have jumped. Sides that do not slide now stick if the force that holds
/// them is there; without true stick they go on as they were.
void renew_friction(Equations &equations, const ContactScales &scales, double time, Vector &state);

} // namespace vibroimpact::motion
