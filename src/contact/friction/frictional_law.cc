#include "contact/friction/frictional_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::contact {

namespace {

bool depends_on_gap_alone(const AffineForm &form) {
  return form.gap_rate == 0 &&
         std::all_of(form.internal.begin(), form.internal.end(), [](double c) { return c == 0; });
}

std::vector<double> coefficients(const AffineForm &form, std::size_t n_internal) {
  std::vector<double> list = {form.constant, form.gap, form.gap_rate};
  list.insert(list.end(), form.internal.begin(), form.internal.end());
  list.resize(3 + n_internal, 0.0);
  return list;
}

// Is one of the forms a positive multiple of the other?
bool same_sign(const AffineForm &form, const AffineForm &other, std::size_t n_internal) {
  const std::vector<double> a = coefficients(form, n_internal);
  const std::vector<double> b = coefficients(other, n_internal);
  double products = 0, first = 0, second = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    products += a[i] * b[i];
    first += a[i] * a[i];
    second += b[i] * b[i];
  }
  return products > (1 - 1e-12) * std::sqrt(first * second);
}

// Does the mode end where its force would pull?
bool only_pushes(const Mode &mode, std::size_t n_internal) {
  const AffineForm &force = mode.affine->force;
  return force.zero() || same_sign(force, {.constant = 1}, n_internal) ||
         std::any_of(mode.guards.begin(), mode.guards.end(), [&](const Guard &guard) {
           return same_sign(force, guard.indicator, n_internal);
         });
}

AffineForm internal_state(std::size_t place) {
  AffineForm form{.internal = std::vector<double>(place + 1, 0.0)};
  form.internal[place] = 1;
  return form;
}

std::vector<double> both(const ContactLaw &normal, const TangentialLaw &tangential) {
  std::vector<double> states = normal.initial_internal();
  states.resize(states.size() + tangential.internal_states().size(), 0.0);
  return states;
}

} // namespace

AffineForm rate_of_normal_force(const AffineForm &normal_force) {
  return {.gap_rate = normal_force.gap};
}

std::string why_no_friction(const ContactLaw &normal, const TangentialLaw &tangential) {
  if (normal.rigid())
    return "rigid sides";
  for (const Mode &mode : normal.modes()) {
    if (!mode.affine)
      return "a normal force that is not linear in contact";
    if (!only_pushes(mode, static_cast<std::size_t>(normal.n_internal())))
      return "a normal force that may pull";
    if (tangential.follows_normal_rate() && !depends_on_gap_alone(mode.affine->force))
      return "a normal force that depends on more than the gap, unless the Damping constant of "
             "the spring-slider is greater than 0";
  }
  return "";
}

struct FrictionalLaw::Product {
  std::vector<Mode> modes;
  std::vector<Part> parts;

  int place(int normal, int tangential) const {
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part &part) {
      return part.normal == normal && (part.tangential == tangential || part.tangential == -1);
    });
    return static_cast<int>(found - parts.begin());
  }
};

// Guards of the normal law: the friction goes on as it is where both modes have it, and begins or
// ends with the force; a spring that is let go relaxes.
FrictionalLaw::Product FrictionalLaw::multiply(const ContactLaw &normal,
                                               const TangentialLaw &tangential) {
  const auto n_normal = static_cast<std::size_t>(normal.n_internal());
  const std::size_t n_own = tangential.internal_states().size();
  Product product;
  for (int m = 0; m < static_cast<int>(normal.modes().size()); ++m) {
    const AffineForm &force = normal.modes()[static_cast<std::size_t>(m)].affine->force;
    const auto count = static_cast<int>(tangential.modes(force, n_normal).size());
    for (int t = force.zero() ? -1 : 0; t < (force.zero() ? 0 : count); ++t)
      product.parts.push_back({.normal = m, .tangential = t});
  }
  for (const Part &part : product.parts) {
    Mode mode = normal.modes()[static_cast<std::size_t>(part.normal)];
    const bool acts = part.tangential >= 0;
    for (Guard &guard : mode.guards) {
      guard.target = product.place(guard.target, std::max(part.tangential, 0));
      const bool goes_on = product.parts[static_cast<std::size_t>(guard.target)].tangential >= 0;
      guard.by_slip = !acts && goes_on;
      if (!acts || goes_on || n_own == 0)
        continue;
      for (std::size_t i = guard.reset.size(); i < n_normal; ++i)
        guard.reset.push_back(internal_state(i));
      guard.reset.resize(n_normal + n_own);
    }
    AffineLaw &law = *mode.affine;
    law.internal_rate.resize(n_normal + n_own);
    if (acts) {
      const TangentialMode own =
          tangential.modes(law.force, n_normal)[static_cast<std::size_t>(part.tangential)];
      mode.name += ", " + own.name;
      mode.friction = own.friction;
      mode.holds_slip = own.holds_slip;
      law.tangential_force[0] = own.force;
      law.sliding_speed = own.sliding_speed;
      std::copy(own.internal_rate.begin(), own.internal_rate.end(),
                law.internal_rate.begin() + static_cast<std::ptrdiff_t>(n_normal));
      for (Guard guard : own.guards) {
        guard.target = product.place(part.normal, guard.target);
        if (!guard.reset.empty())
          for (std::size_t i = 0; i < n_normal; ++i)
            guard.reset.insert(guard.reset.begin() + static_cast<std::ptrdiff_t>(i),
                               internal_state(i));
        mode.guards.push_back(std::move(guard));
      }
    }
    product.modes.push_back(std::move(mode));
  }
  return product;
}

FrictionalLaw::FrictionalLaw(std::shared_ptr<const ContactLaw> normal,
                             std::shared_ptr<const TangentialLaw> tangential)
    : FrictionalLaw(normal, tangential, multiply(*normal, *tangential)) {}

FrictionalLaw::FrictionalLaw(std::shared_ptr<const ContactLaw> normal,
                             std::shared_ptr<const TangentialLaw> tangential, Product product)
    : ContactLaw(std::move(product.modes), both(*normal, *tangential)), normal_(std::move(normal)),
      tangential_(std::move(tangential)), parts_(std::move(product.parts)) {}

std::vector<InternalState> FrictionalLaw::internal_states() const {
  std::vector<InternalState> states = normal_->internal_states();
  for (InternalState &own : tangential_->internal_states())
    states.push_back(std::move(own));
  return states;
}

LocalState FrictionalLaw::of_normal(const LocalState &state) const {
  LocalState part = state;
  part.internal = state.internal.first(static_cast<std::size_t>(normal_->n_internal()));
  return part;
}

int FrictionalLaw::mode_of(int normal, int tangential) const {
  return Product{.modes = {}, .parts = parts_}.place(normal, tangential);
}

int FrictionalLaw::initial_mode(const LocalState &state) const {
  return mode_by_slip(mode_of(normal_->initial_mode(of_normal(state)), 0), state);
}

int FrictionalLaw::mode_by_slip(int mode, const LocalState &state) const {
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  return part.tangential < 0
             ? mode
             : mode_of(part.normal,
                       tangential_->mode_by_slip(part.tangential, state.tangential[0].slip_rate));
}

void FrictionalLaw::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  normal_->evaluate(parts_[static_cast<std::size_t>(mode)].normal, of_normal(state), response);
  const AffineLaw &law = *modes()[static_cast<std::size_t>(mode)].affine;
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  const auto n = static_cast<std::size_t>(n_internal());
  TangentialResponse &tangential = response.tangential[0];
  tangential.by = law.tangential_force[0];
  tangential.force = tangential.by(state);
  tangential.by.constant = 0;
  response.sliding_speed = law.sliding_speed(state);
  // What goes in, less what deforms stores; where all of it deforms, what the dashpots take. Terms
  // that cancel would hide the others.
  const bool sticks = modes()[static_cast<std::size_t>(mode)].friction == Friction::stick;
  response.friction_power = sticks ? 0 : -tangential.force * state.tangential[0].slip_rate;
  tangential.internal_rate_by_slip_rate.assign(n, 0);
  response.force_by_internal.resize(n, 0);
  response.internal_rate.resize(n, 0);
  response.internal_rate_by_gap.resize(n, 0);
  response.internal_rate_by_gap_rate.resize(n, 0);
  std::vector<double> by_internal(n * n, 0.0);
  for (std::size_t i = 0; i < n_normal; ++i)
    std::copy_n(response.internal_rate_by_internal.data() + i * n_normal, n_normal,
                by_internal.data() + i * n);
  for (std::size_t i = n_normal; i < n; ++i) {
    const AffineForm &rate = law.internal_rate[i];
    response.force_by_internal[i] = 0;
    response.internal_rate[i] = rate(state);
    response.internal_rate_by_gap[i] = rate.gap;
    response.internal_rate_by_gap_rate[i] = rate.gap_rate;
    std::copy(rate.internal.begin(), rate.internal.end(), by_internal.data() + i * n);
    tangential.internal_rate_by_slip_rate[i] = rate.tangential[0].rate;
    const double pull = tangential_->stiffness() * state.internal[i];
    response.stored_energy += 0.5 * pull * state.internal[i];
    response.friction_power +=
        (sticks ? tangential_->damping_constant() * response.internal_rate[i] : -pull) *
        response.internal_rate[i];
  }
  response.internal_rate_by_internal = std::move(by_internal);
  response.dissipated_power += response.friction_power;
}

} // namespace vibroimpact::contact
