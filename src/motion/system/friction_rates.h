// What friction adds to the third derivatives of a motion, by the chain rule.
#pragma once

#include "motion/system/equations.h"

namespace vibroimpact::motion {

/// The rate of a normal force from its partial derivatives and the rates of the local state.
double rate_of_force(const contact::LawResponse &response, const contact::LocalState &change);

/// `response`: of the contact's law at the point, whose rates are known. Adds the rates of its
/// tangential forces to the rows of the velocities of EndPoint::higher, before the division by the
/// mass, and what slip accelerations add to the second derivatives of its internal states.
void add_friction_rates(const Equations &equations, std::size_t contact,
                        const contact::LawResponse &response, EndPoint &point);

} // namespace vibroimpact::motion
