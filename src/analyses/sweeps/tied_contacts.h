// Contacts whose sides are tied together in a linear analysis: the limit of a contact that never
// opens, with a stiffness without bound. The other limit is the system with all contacts open.
#pragma once

#include "analyses/run/system.h"

#include <functional>
#include <vector>

namespace vibroimpact::analyses {

/// The gaps of a system that do not change. InputError for unknown contacts and circular gaps.
using TiedContacts = std::function<std::vector<model::Projection>(const System &)>;

/// Declares the key Tied contacts.
void declare_tied_contacts(parameters::Section &section);
TiedContacts read_tied_contacts(const parameters::Values &section);

/// Their rows: k x n, of a model with n coordinates.
Matrix rows_of(const std::vector<model::Projection> &gaps, Index n);

} // namespace vibroimpact::analyses
