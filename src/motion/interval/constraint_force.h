// What the equations give along one step that its polynomials do not say: forces that hold a
// direction of a contact, and what laws of friction give by value.
#pragma once

#include "motion/interval/step_view.h"

#include <functional>

namespace vibroimpact::motion {

/// A value of the local state of a contact.
using LocalValue = std::function<double(const contact::LocalState &)>;

/// Polynomial of degree 9 through the values that the equations give for the dense states of the
/// step at its ends, exactly, and at eight instants between.
Bernstein local_curve(const StepView &view, std::size_t contact, const LocalValue &value);

/// The same as a function of tau in [0, 1], without a polynomial between: a circular gap has no
/// slope where u passes the middle.
std::function<double(double tau)> local_function(const StepView &view, std::size_t contact,
                                                 LocalValue value);

/// The force that holds a direction of a contact; zero of one that is not held.
Bernstein constraint_force(const StepView &view, std::size_t contact, int direction);

} // namespace vibroimpact::motion
