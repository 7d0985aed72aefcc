#include "motion/interval/phase_forms.h"

#include <utility>

namespace vibroimpact::motion {

PhaseForms::PhaseForms(const Equations &equations)
    : contact_modes_(equations.modes()), guard_forms_(motion::guard_forms(equations)) {
  for (std::size_t c = 0; c < contact_modes_.size(); ++c)
    add_guards(equations, c);
}

void PhaseForms::add_guards(const Equations &equations, std::size_t contact) {
  const contact::ContactPair &pair = equations.contacts().pairs()[contact];
  const contact::Mode &mode = equations.mode(contact);
  for (std::size_t g = 0; g < mode.guards.size(); ++g) {
    guards_.push_back({.contact = contact, .guard = g, .target = mode.guards[g].target});
    std::vector<Reset> &resets = resets_.emplace_back();
    for (std::size_t i = 0; i < mode.guards[g].reset.size(); ++i)
      resets.push_back(
          {.entry = equations.layout().internal() + pair.internal_offset + static_cast<Index>(i),
           .form = linear_row(equations, contact, mode.guards[g].reset[i])});
  }
}

} // namespace vibroimpact::motion
