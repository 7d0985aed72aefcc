// Friction along every direction, of contacts that part and of elements that do not.
#pragma once

#include "random_models/random_contacts.h"

namespace vibroimpact::testing {

/// Masses that move along one axis or two, or a beam whose nodes stand off its axis, so that they
/// move along it as it bends.
RandomBodies random_sliding_bodies(Draw &draw, double factor);

/// One to three contacts f0, f1... with friction of any law, now and then on a moving surface: with
/// a constant normal force on all points, with one that parts on those that move along two axes.
/// Beside them, now and then, contacts k0... without friction. `rigid`: those that part have rigid
/// sides with Coulomb's friction.
RandomContacts random_friction(Draw &draw, const RandomBodies &bodies, bool rigid);

} // namespace vibroimpact::testing
