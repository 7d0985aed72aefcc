// Contacts that cannot close in an analysis, and whose gap is recorded nevertheless.
#pragma once

#include "contact/contact_set.h"

#include <string>
#include <vector>

namespace vibroimpact::contact {

/// The contacts of the sections `names` keep their gap and lose force and friction.
ContactSet without_force(const ContactSet &contacts, const std::vector<std::string> &names);

} // namespace vibroimpact::contact
