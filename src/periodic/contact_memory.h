// Internal states of open contacts that act on nothing: what a contact remembers of its latest
// impact until the next one, such as the approach speed by which a damping was chosen.
//
// In the mode of the contact the force, the rates and the guards do not depend on the state, it
// does not change, and every guard that ends the mode sets it anew. A motion without contact keeps
// it for ever, whatever it is: a false multiplier 1, with a family of periodic motions that differ
// in it alone. The maps of periodic motions therefore begin with these states at zero.
#pragma once

#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::periodic {

/// Places in the physical state, in the present modes of the equations.
std::vector<Index> idle_memory(const motion::Equations &equations);

} // namespace vibroimpact::periodic
