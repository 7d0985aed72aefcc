#include "contact/friction/frictional_law.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace vibroimpact::contact {

namespace {

bool depends_on_gap_alone(const AffineForm &form) {
  return form.gap_rate == 0 && form.normal_force == 0 &&
         std::all_of(form.internal.begin(), form.internal.end(), [](double c) { return c == 0; });
}

bool sees_rate(const AffineForm &form) { return form.normal_force_rate != 0; }

bool sees_rate(const std::vector<AffineForm> &forms) {
  return std::any_of(forms.begin(), forms.end(), [](const AffineForm &f) { return sees_rate(f); });
}

bool sees_rate(const TangentialMode &mode) {
  return sees_rate(mode.sliding_speed) || sees_rate(mode.internal_rate) ||
         std::any_of(mode.guards.begin(), mode.guards.end(), [](const Guard &guard) {
           return sees_rate(guard.indicator) || sees_rate(guard.reset);
         });
}

// As a form: by value where the mode has none.
AffineForm normal_force_of(const Mode &mode) {
  return mode.affine ? mode.affine->force : AffineForm::force_along(0);
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
  return depends_on_gap_alone(normal_force) ? AffineForm{.gap_rate = normal_force.gap}
                                            : AffineForm{.normal_force_rate = 1};
}

void TangentialLaw::evaluate(int /*mode*/, const LocalState & /*state*/,
                             std::size_t /*first_internal*/, TangentialValues & /*values*/) const {
  throw std::logic_error("a law of friction has a mode that it does not evaluate: " + name());
}

std::string why_no_friction(const ContactLaw &normal) {
  if (normal.rigid())
    return "rigid sides";
  const auto n_internal = static_cast<std::size_t>(normal.n_internal());
  for (const Mode &mode : normal.modes())
    if (mode.affine ? !only_pushes(mode, n_internal) : normal.may_pull())
      return "a normal force that may pull";
  return "";
}

struct FrictionalLaw::Product {
  std::vector<Mode> modes;
  std::vector<Part> parts;
  std::vector<AffineLaw> forms;
  std::vector<char> evaluated;

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
    const AffineForm force = normal_force_of(normal.modes()[static_cast<std::size_t>(m)]);
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
    AffineLaw &forms = product.forms.emplace_back(mode.affine.value_or(AffineLaw{}));
    forms.internal_rate.resize(n_normal + n_own);
    product.evaluated.push_back(0);
    if (acts) {
      const TangentialMode own = tangential.modes(
          normal_force_of(mode), n_normal)[static_cast<std::size_t>(part.tangential)];
      mode.name += ", " + own.name;
      mode.friction = own.friction;
      mode.holds_slip = own.holds_slip;
      mode.sees_force_rate = sees_rate(own);
      product.evaluated.back() = own.evaluated ? 1 : 0;
      if (own.evaluated)
        mode.affine.reset();
      forms.tangential_force[0] = own.force;
      forms.sliding_speed = own.sliding_speed;
      std::copy(own.internal_rate.begin(), own.internal_rate.end(),
                forms.internal_rate.begin() + static_cast<std::ptrdiff_t>(n_normal));
      for (Guard guard : own.guards) {
        guard.target = product.place(part.normal, guard.target);
        if (!guard.reset.empty())
          for (std::size_t i = 0; i < n_normal; ++i)
            guard.reset.insert(guard.reset.begin() + static_cast<std::ptrdiff_t>(i),
                               internal_state(i));
        mode.guards.push_back(std::move(guard));
      }
    }
    if (mode.affine)
      mode.affine = forms;
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
      tangential_(std::move(tangential)), parts_(std::move(product.parts)),
      forms_(std::move(product.forms)), evaluated_(std::move(product.evaluated)) {}

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
  return Product{.modes = {}, .parts = parts_, .forms = {}, .evaluated = {}}.place(normal,
                                                                                   tangential);
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

// The derivatives of a rate of the force by the state, beside those that its derivatives have: at
// constant rates of the state they are those of the derivatives of the force along it.
void FrictionalLaw::add_curvature(int mode, const LocalState &state, const LawResponse &normal,
                                  AffineForm &rate) const {
  constexpr double part = 1e-4; // of the penetration
  const auto n = static_cast<std::size_t>(normal_->n_internal());
  const double step = std::min(1.0, part * std::abs(state.gap / state.gap_rate));
  if (step == 0)
    return;
  LawResponse side;
  std::vector<double> internal(n);
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < n; ++i)
      internal[i] = state.internal[i] + sign * step * normal.internal_rate[i];
    normal_->evaluate(parts_[static_cast<std::size_t>(mode)].normal,
                      {.gap = state.gap + sign * step * state.gap_rate,
                       .gap_rate = state.gap_rate + sign * step * state.gap_acceleration,
                       .internal = internal},
                      side);
    const double weight = sign / (2 * step);
    rate.gap += weight * side.force_by_gap;
    rate.gap_rate += weight * side.force_by_gap_rate;
    for (std::size_t i = 0; i < n; ++i)
      rate.internal[i] += weight * side.force_by_internal[i];
  }
}

// N' = N_g g' + N_g' g'' + N_z z'
FrictionalLaw::NormalForce FrictionalLaw::normal_force(int mode, const LocalState &state,
                                                       const LawResponse &normal) const {
  const auto n = static_cast<std::size_t>(normal_->n_internal());
  NormalForce made;
  made.force = {.gap = normal.force_by_gap,
                .gap_rate = normal.force_by_gap_rate,
                .internal = {normal.force_by_internal.begin(), normal.force_by_internal.end()}};
  if (!modes()[static_cast<std::size_t>(mode)].sees_force_rate)
    return made;
  made.rate = {.gap_rate = normal.force_by_gap, .internal = std::vector<double>(n, 0.0)};
  made.by_gap_acceleration = normal.force_by_gap_rate;
  for (std::size_t k = 0; k < n; ++k) {
    const double by_internal = normal.force_by_internal[k];
    made.rate.gap += by_internal * normal.internal_rate_by_gap[k];
    made.rate.gap_rate += by_internal * normal.internal_rate_by_gap_rate[k];
    for (std::size_t j = 0; j < n; ++j)
      made.rate.internal[j] += by_internal * normal.internal_rate_by_internal[k * n + j];
  }
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  if (!normal_->modes()[static_cast<std::size_t>(part.normal)].affine)
    add_curvature(mode, state, normal, made.rate);
  return made;
}

// At a state that has the normal force.
TangentialValues FrictionalLaw::friction(int mode, const LocalState &state) const {
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  const AffineLaw &forms = forms_[static_cast<std::size_t>(mode)];
  TangentialValues values;
  if (evaluated_[static_cast<std::size_t>(mode)]) {
    tangential_->evaluate(part.tangential, state, n_normal, values);
    return values;
  }
  const auto of = [&](const AffineForm &form) {
    TangentialValue made{.value = form(state), .by = form};
    made.by.constant = 0;
    return made;
  };
  values.force = of(forms.tangential_force[0]);
  for (std::size_t i = n_normal; i < forms.internal_rate.size(); ++i)
    values.internal_rate.push_back(of(forms.internal_rate[i]));
  values.sliding_speed = forms.sliding_speed(state);
  return values;
}

// The internal states of the normal law stand before those of the tangential one.
void FrictionalLaw::add_friction(const NormalForce &normal, const TangentialValues &friction,
                                 LawResponse &response) const {
  const auto by_state = [&](AffineForm by) {
    const double force = std::exchange(by.normal_force, 0);
    const double rate = std::exchange(by.normal_force_rate, 0);
    if (force != 0)
      by += force * normal.force;
    if (rate != 0)
      by += rate * normal.rate;
    return by;
  };
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  const auto n = static_cast<std::size_t>(n_internal());
  TangentialResponse &tangential = response.tangential[0];
  tangential.force = friction.force.value;
  tangential.by = by_state(friction.force.by);
  tangential.internal_rate_by_slip_rate.assign(n, 0);
  for (std::vector<double> *list :
       {&response.force_by_internal, &response.internal_rate, &response.internal_rate_by_gap,
        &response.internal_rate_by_gap_rate})
    list->resize(n, 0);
  response.internal_rate_by_gap_acceleration.assign(n, 0);
  std::vector<double> by_internal(n * n, 0.0);
  for (std::size_t i = 0; i < n_normal; ++i)
    std::copy_n(response.internal_rate_by_internal.data() + i * n_normal, n_normal,
                by_internal.data() + i * n);
  for (std::size_t i = n_normal; i < n; ++i) {
    const TangentialValue &rate = friction.internal_rate[i - n_normal];
    const AffineForm by = by_state(rate.by);
    response.force_by_internal[i] = 0;
    response.internal_rate[i] = rate.value;
    response.internal_rate_by_gap[i] = by.gap;
    response.internal_rate_by_gap_rate[i] = by.gap_rate;
    response.internal_rate_by_gap_acceleration[i] =
        rate.by.normal_force_rate * normal.by_gap_acceleration;
    std::copy(by.internal.begin(), by.internal.end(), by_internal.data() + i * n);
    tangential.internal_rate_by_slip_rate[i] = by.tangential[0].rate;
  }
  response.internal_rate_by_internal = std::move(by_internal);
}

// What goes in, less what deforms stores; where all of it deforms, what the dashpots take. Terms
// that cancel would hide the others.
void FrictionalLaw::add_work(int mode, const LocalState &state, const TangentialValues &friction,
                             LawResponse &response) const {
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  const bool sticks = modes()[static_cast<std::size_t>(mode)].friction == Friction::stick;
  response.sliding_speed = friction.sliding_speed;
  response.friction_power = sticks ? 0 : -friction.force.value * state.tangential[0].slip_rate;
  for (std::size_t i = 0; i < friction.internal_rate.size(); ++i) {
    const double deformation = state.internal[n_normal + i];
    const double rate = friction.internal_rate[i].value;
    const double pull = tangential_->stiffness() * deformation;
    response.stored_energy += 0.5 * pull * deformation;
    response.friction_power += (sticks ? tangential_->damping_constant() * rate : -pull) * rate;
  }
  response.dissipated_power += response.friction_power;
}

void FrictionalLaw::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  normal_->evaluate(parts_[static_cast<std::size_t>(mode)].normal, of_normal(state), response);
  LocalState seen = state;
  seen.normal_force = response.force;
  const TangentialValues values = friction(mode, seen);
  const NormalForce normal = normal_force(mode, state, response);
  add_friction(normal, values, response);
  add_work(mode, state, values, response);
}

} // namespace vibroimpact::contact
