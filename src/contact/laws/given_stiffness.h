// Of laws whose stiffness the contact may set.
#pragma once

#include "parameters/values.h"

namespace vibroimpact::contact {

/// InputError when the section of a law has a Stiffness beside that of the contact.
inline void refuse_stiffness(const parameters::Values &law) {
  if (law.given("Stiffness"))
    law.reject("Stiffness", "must not be set when the contact has a Stiffness fraction");
}

} // namespace vibroimpact::contact
