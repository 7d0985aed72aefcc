// Do two contact laws do the same?
#pragma once

#include "contact/contact_law.h"

namespace vibroimpact::contact {

/// By what they do at some local states of the given size (gaps in m, rates in m/s), in all modes,
/// whatever they are made of: forces, internal rates, guards, resets and restitution agree to
/// 1e-12.
bool same_law(const ContactLaw &a, const ContactLaw &b, double size);

} // namespace vibroimpact::contact
