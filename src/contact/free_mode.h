// The mode of a law in which its sides are apart.
#pragma once

#include "contact/contact_law.h"

#include <optional>

namespace vibroimpact::contact {

/// No force in that mode, whatever the gap, and internal states at rest.
bool forceless(const Mode &mode);

/// The first mode out of contact without force; none: the sides are never free of each other.
std::optional<int> free_mode(const ContactLaw &law);

} // namespace vibroimpact::contact
