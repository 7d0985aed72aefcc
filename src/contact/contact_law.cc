#include "contact/contact_law.h"

#include <algorithm>

#include <cstddef>
#include <utility>

namespace vibroimpact::contact {

double AffineForm::operator()(const LocalState &state) const {
  double value = constant + gap * state.gap + gap_rate * state.gap_rate;
  if (normal_force != 0)
    value += normal_force * state.normal_force;
  if (normal_force_rate != 0)
    value += normal_force_rate * state.normal_force_rate;
  if (margin != 0)
    value += margin * state.margin;
  for (std::size_t i = 0; i < internal.size(); ++i)
    value += internal[i] * state.internal[i];
  for (std::size_t k = 0; k < most_tangential; ++k)
    if (!tangential[k].zero())
      value += tangential[k].position * state.tangential[k].slip +
               tangential[k].rate * state.tangential[k].slip_rate +
               tangential[k].force * state.tangential[k].force;
  return value;
}

AffineForm AffineForm::position_along(int direction) {
  AffineForm form;
  (direction == 0 ? form.gap : form.tangential[static_cast<std::size_t>(direction - 1)].position) =
      1;
  return form;
}

AffineForm AffineForm::rate_along(int direction) {
  AffineForm form;
  (direction == 0 ? form.gap_rate : form.tangential[static_cast<std::size_t>(direction - 1)].rate) =
      1;
  return form;
}

AffineForm AffineForm::force_along(int direction) {
  AffineForm form;
  (direction == 0 ? form.normal_force
                  : form.tangential[static_cast<std::size_t>(direction - 1)].force) = 1;
  return form;
}

bool AffineForm::zero() const {
  const auto is_zero = [](double c) { return c == 0; };
  return constant == 0 && gap == 0 && gap_rate == 0 && margin == 0 && !sees_normal_force() &&
         std::all_of(internal.begin(), internal.end(), is_zero) &&
         std::all_of(tangential.begin(), tangential.end(),
                     [](const DirectionForm &form) { return form.zero(); });
}

bool AffineForm::sees_forces() const {
  return sees_normal_force() ||
         std::any_of(tangential.begin(), tangential.end(),
                     [](const DirectionForm &form) { return form.force != 0; });
}

AffineForm &AffineForm::operator+=(const AffineForm &other) {
  constant += other.constant;
  gap += other.gap;
  gap_rate += other.gap_rate;
  normal_force += other.normal_force;
  normal_force_rate += other.normal_force_rate;
  margin += other.margin;
  internal.resize(std::max(internal.size(), other.internal.size()), 0.0);
  for (std::size_t i = 0; i < other.internal.size(); ++i)
    internal[i] += other.internal[i];
  for (std::size_t k = 0; k < most_tangential; ++k) {
    tangential[k].position += other.tangential[k].position;
    tangential[k].rate += other.tangential[k].rate;
    tangential[k].force += other.tangential[k].force;
  }
  return *this;
}

AffineForm &AffineForm::operator*=(double factor) {
  for (double *c : {&constant, &gap, &gap_rate, &normal_force, &normal_force_rate, &margin})
    *c *= factor;
  for (double &c : internal)
    c *= factor;
  for (DirectionForm &form : tangential)
    for (double *c : {&form.position, &form.rate, &form.force})
      *c *= factor;
  return *this;
}

AffineForm operator*(double factor, AffineForm form) { return form *= factor; }
AffineForm operator+(AffineForm form, const AffineForm &other) { return form += other; }

double LimitCircle::operator()(const LocalState &state) const {
  const double r = radius(state);
  double value = r * r;
  for (const AffineForm &form : across) {
    const double part = form(state);
    value -= part * part;
  }
  return value;
}

AffineForm LimitCircle::gradient(const LocalState &state) const {
  AffineForm made = 2 * radius(state) * radius;
  for (const AffineForm &form : across)
    made += -2 * form(state) * form;
  made.constant = 0;
  return made;
}

ContactLaw::ContactLaw(std::vector<Mode> modes, std::vector<double> initial_internal)
    : modes_(std::move(modes)), initial_internal_(std::move(initial_internal)) {}

bool ContactLaw::rigid() const {
  return std::any_of(modes_.begin(), modes_.end(), [](const Mode &mode) {
    return std::any_of(mode.guards.begin(), mode.guards.end(),
                       [](const Guard &guard) { return guard.action == GuardAction::impact; });
  });
}

bool ContactLaw::always_in_contact() const {
  return std::all_of(modes_.begin(), modes_.end(),
                     [](const Mode &mode) { return mode.in_contact; });
}

std::optional<ElasticForce> ContactLaw::elastic_force() const {
  if (const std::optional<PowerLaw> law = power_law())
    return ElasticForce{.stiffness = law->stiffness, .exponent = law->exponent};
  return std::nullopt;
}

SettledMode settle(const ContactLaw &law, LocalState state) {
  SettledMode settled{.mode = law.initial_mode(state),
                      .internal = {state.internal.begin(), state.internal.end()}};
  // Each mode is entered once at most; a law whose guards contradict each other stays where it is.
  for (std::size_t i = 0; i < law.modes().size(); ++i) {
    const Mode &mode = law.modes()[static_cast<std::size_t>(settled.mode)];
    const auto passed =
        std::find_if(mode.guards.begin(), mode.guards.end(),
                     [&](const Guard &guard) { return guard.indicator(state) < 0; });
    if (passed == mode.guards.end())
      break;
    std::vector<double> internal = settled.internal;
    for (std::size_t k = 0; k < passed->reset.size(); ++k)
      internal[k] = passed->reset[k](state);
    settled = {.mode = passed->target, .internal = std::move(internal)};
    state.internal = settled.internal;
  }
  return settled;
}

std::vector<InternalState> ContactLaw::internal_states() const {
  std::vector<InternalState> states;
  for (int i = 0; i < n_internal(); ++i)
    states.push_back({.name = "internal_" + std::to_string(i),
                      .unit = "1",
                      .description = "Internal state of the law, in SI units"});
  return states;
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

} // namespace vibroimpact::contact
