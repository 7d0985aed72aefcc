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

/// Of laws that are written in the file, tables and formulas, or of all others.
RandomContacts random_contacts(Draw &draw, const RandomBodies &bodies, bool written = false);
/// Up to two connections to the ground with such a tension.
std::string random_tensions(Draw &draw, const RandomBodies &bodies);

} // namespace vibroimpact::testing
