#include "contact/contact_law.h"

#include <cstddef>
#include <utility>

namespace vibroimpact {

double AffineForm::operator()(const LocalState &state) const {
  double value = constant + gap * state.gap + gap_rate * state.gap_rate;
  for (std::size_t i = 0; i < internal.size(); ++i)
    value += internal[i] * state.internal[i];
  return value;
}

ContactLaw::ContactLaw(std::vector<Mode> modes, std::vector<double> initial_internal)
    : modes_(std::move(modes)), initial_internal_(std::move(initial_internal)) {}

std::vector<double> entered_internal(const ContactLaw &law, int mode, const LocalState &state) {
  std::vector<double> internal(state.internal.begin(), state.internal.end());
  for (const Mode &from : law.modes())
    for (const Guard &guard : from.guards)
      if (guard.target == mode && !guard.reset.empty()) {
        for (std::size_t i = 0; i < internal.size(); ++i)
          internal[i] = guard.reset[i](state);
        return internal;
      }
  return internal;
}

std::vector<Mode> open_and_contact(std::optional<AffineLaw> affine_contact) {
  return {{.name = "open",
           .in_contact = false,
           .guards = {{.indicator = {.gap = 1}, .target = 1}},
           .affine = AffineLaw{}},
          {.name = "contact",
           .in_contact = true,
           .guards = {{.indicator = {.gap = -1}, .target = 0}},
           .affine = std::move(affine_contact)}};
}

int open_or_contact(const LocalState &state) { return state.gap < 0 ? 1 : 0; }

} // namespace vibroimpact
