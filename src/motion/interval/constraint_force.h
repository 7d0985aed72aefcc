// The force that holds a direction of a contact, along one step.
#pragma once

#include "motion/interval/step_view.h"

namespace vibroimpact::motion {

/// Polynomial of degree 9 through the forces that the equations give for the dense states of the
/// step at its ends, exactly, and at eight instants between. Zero of a direction that is not held.
Bernstein constraint_force(const StepView &view, std::size_t contact, int direction);

} // namespace vibroimpact::motion
