// Connections whose tension follows a table, a formula or a model with memory: contacts that never
// part.
#pragma once

#include "contact/contact_set.h"

namespace vibroimpact::contact {

/// Declares the sections of a connection that hold its law.
void declare_connection_laws(parameters::Section &root);

/// The contacts, and behind them one pair for each connection of the file with a Law; its gap is
/// the elongation, its force the tension with the opposite sign. Throws InputError.
ContactSet with_connections(const parameters::Values &root, const model::Model &model,
                            ContactSet contacts);

} // namespace vibroimpact::contact
