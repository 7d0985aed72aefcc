// Contacts at bodies that are given by some of their modes, of whose static flexibility nothing
// else is known.
#pragma once

#include "contact/contact_set.h"

#include <set>
#include <string>

namespace vibroimpact::contact {

/// One sentence that names the points, the flexibility of the given modes there, and the share of
/// the highest of them, which tells how fast their sum converges; empty without such contacts.
/// `known`: points that were named before; those named now are added.
std::string unknown_flexibility_warning(const ContactSet &contacts, const model::Model &model,
                                        std::set<std::string> &known);

} // namespace vibroimpact::contact
