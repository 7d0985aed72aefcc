#include "contact/free_mode.h"

namespace vibroimpact::contact {

bool forceless(const Mode &mode) {
  return !mode.holds_gap && mode.affine && mode.affine->force.zero();
}

std::optional<int> free_mode(const ContactLaw &law) {
  for (std::size_t m = 0; m < law.modes().size(); ++m)
    if (!law.modes()[m].in_contact && forceless(law.modes()[m]))
      return static_cast<int>(m);
  return std::nullopt;
}

} // namespace vibroimpact::contact
