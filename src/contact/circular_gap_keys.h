// The keys of circular gaps in a section "Contact".
#pragma once

#include "contact/contact_group.h"
#include "contact/contact_set.h"
#include "parameters/values.h"

#include <string>

namespace vibroimpact::contact {

void declare_circular_gap(parameters::Section &contact);

bool has_circular_gap(const parameters::Values &contact);

/// Gives a pair that was made with the plane gap along Direction its circular one; InputError for
/// what does not go with it.
void bend_gap(const parameters::Values &contact, const Meeting &meeting, const std::string &fixed,
              const model::Model &model, ContactPair &pair);

} // namespace vibroimpact::contact
