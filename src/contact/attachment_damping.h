// Contacts whose attachment modes ring: each impact leaves energy in them that a real structure
// loses.
#pragma once

#include "contact/contact_set.h"

#include <set>
#include <string>

namespace vibroimpact::contact {

/// One sentence that names the points of contacts whose attachment modes have a damping ratio below
/// 0.05, with the least of the ratios and what to set; empty where there are none. `known`: points
/// that were named before; those named now are added.
std::string attachment_damping_warning(const ContactSet &contacts, const model::Model &model,
                                       std::set<std::string> &known);

} // namespace vibroimpact::contact
