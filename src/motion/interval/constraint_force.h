// The force that holds a contact's gap, along one step.
#pragma once

#include "motion/interval/step_view.h"

namespace vibroimpact::motion {

/// Polynomial of degree 9 through the forces that the equations give for the dense states of the
/// step at its ends, exactly, and at eight instants between. Zero of a contact that is not held.
Bernstein constraint_force(const StepView &view, std::size_t contact);

} // namespace vibroimpact::motion
