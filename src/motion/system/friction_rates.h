// What contacts add to the third derivatives of a motion, by the chain rule.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// The rate of a normal force from its partial derivatives and the rates of the local state.
double rate_of_force(const contact::LawResponse &response, const contact::LocalState &change);

/// Adds the rates of the contact's forces to the rows of the velocities of EndPoint::higher, before
/// the division by the mass, at a point whose rates are known, and sets the second derivatives of
/// its internal states. `response` is storage.
void add_contact_rates(const Equations &equations, std::size_t contact,
                       contact::LawResponse &response, EndPoint &point);

/// The same of a contact in a circular gap.
void add_circular_rates(const Equations &equations, std::size_t contact,
                        contact::LawResponse &response, EndPoint &point);

} // namespace vibroimpact::motion
