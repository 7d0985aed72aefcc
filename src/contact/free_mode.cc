#include "contact/free_mode.h"

#include <algorithm>

namespace vibroimpact::contact {

bool forceless(const Mode &mode) {
  const auto zero = [](const AffineForm &form) { return form.zero(); };
  return !mode.holds() && mode.affine && zero(mode.affine->force) &&
         std::ranges::all_of(mode.affine->tangential_force, zero) &&
         std::ranges::all_of(mode.affine->internal_rate, zero);
}

std::optional<int> free_mode(const ContactLaw &law) {
  for (std::size_t m = 0; m < law.modes().size(); ++m)
    if (!law.modes()[m].in_contact && forceless(law.modes()[m]))
      return static_cast<int>(m);
  return std::nullopt;
}

} // namespace vibroimpact::contact
