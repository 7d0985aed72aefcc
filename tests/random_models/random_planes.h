// Bodies that move in a plane or in space, with friction along two directions and in circular gaps.
#pragma once

#include "random_models/random_contacts.h"

namespace vibroimpact::testing {

/// Masses, some of them free; `in_space`: some move along z too.
RandomBodies random_planar_bodies(Draw &draw, double factor, bool in_space);

/// Contacts with friction along two directions, whose sides part or are pressed on each other.
RandomContacts random_planar_friction(Draw &draw, const RandomBodies &bodies);

/// Rings about masses or masses beside each other, with friction or without. `rigid`: their sides.
RandomContacts random_rings(Draw &draw, const RandomBodies &bodies, bool rigid);

} // namespace vibroimpact::testing
