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

std::vector<InternalState> ContactLaw::internal_states() const {
  std::vector<InternalState> states;
  for (int i = 0; i < n_internal(); ++i)
    states.push_back({.name = "internal_" + std::to_string(i),
                      .unit = "1",
                      .description = "Internal state of the law, in SI units"});
  return states;
}

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

std::vector<Mode> open_contact_separating(const AffineForm &push,
                                          std::optional<AffineLaw> affine_contact,
                                          const AffineLaw &no_force) {
  const AffineForm overlap{.gap = -1};
  AffineForm pull{.constant = -push.constant, .gap = -push.gap, .gap_rate = -push.gap_rate};
  for (const double coefficient : push.internal)
    pull.internal.push_back(-coefficient);
  return {
      {.name = "open",
       .in_contact = false,
       .guards = {{.indicator = {.gap = 1}, .target = 1}},
       .affine = no_force},
      {.name = "contact",
       .in_contact = true,
       .guards = {{.indicator = overlap, .target = 0}, {.indicator = push, .target = 2}},
       .affine = std::move(affine_contact)},
      {.name = "separating",
       .in_contact = true,
       .guards = {{.indicator = overlap, .target = 0}, {.indicator = pull, .target = 1}},
       .affine = no_force},
  };
}

int open_or_contact(const LocalState &state) { return state.gap < 0 ? 1 : 0; }

} // namespace vibroimpact
