// Contacts of every law.
#pragma once

#include "random_models/random_bodies.h"

namespace vibroimpact::testing {

struct RandomContacts {
  std::string text;
  std::string stop; ///< a point with a contact against a stop or base; empty: none
  double onset = 0; ///< displacement of it along the bodies' direction at which that begins [m]
};

double random_clearance(Draw &draw, bool rigid); ///< [m]

RandomContacts random_contacts(Draw &draw, const RandomBodies &bodies);

} // namespace vibroimpact::testing
