// Deviations through a contact from touch to release in closed form, where it is the only nonlinear
// one: it is solved as a whole from its touch (collocation/), whichever way the motion itself went
// through it, and its equations are differentiated (contact_map.h).
#pragma once

#include "motion/phase/exact_phases.h"
#include "motion/variation/joint_integration.h"

#include <optional>

namespace vibroimpact::motion {

/// The only contact whose present mode is nonlinear, where it is of a kind that may be solved as a
/// whole along one direction: a law with force_pulse() in its mode and without internal states.
std::optional<std::size_t> contact_episode(const Equations &equations);

/// Takes the columns, deviations of the physical state, from the start of the part to its end,
/// which are touch and release of the contact. Returns the integral of the divergence; none where
/// the contact is not solved as a whole: the columns are as before. The equations are in the modes
/// of the contact, and are so again.
std::optional<double> pass_contact_episode(const SmoothPart &part, std::size_t contact,
                                           Equations &equations, ExactPhases &phases,
                                           double tolerance, Matrix &columns);

} // namespace vibroimpact::motion
