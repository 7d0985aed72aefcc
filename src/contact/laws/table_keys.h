// The keys of a law that is given as a table.
#pragma once

#include "contact/laws/crush_curves.h"
#include "parameters/values.h"

#include <optional>

namespace vibroimpact::contact {

struct TableKeys {
  ForceCurve loading;
  double damping_constant = 0; ///< [N s/m]
  bool pulls = false;
  std::optional<CrushCurves> crush{};
};

/// Declares the section "Table" of a contact.
void declare_table(parameters::Section &contact);
/// Throws InputError.
TableKeys read_table(const parameters::Values &contact);

} // namespace vibroimpact::contact
