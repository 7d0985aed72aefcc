#include "contact/friction/frictional_law.h"

#include <algorithm>
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
  return mode.sees_force_rate || sees_rate(mode.sliding_speed) || sees_rate(mode.internal_rate) ||
         std::any_of(mode.guards.begin(), mode.guards.end(), [](const Guard &guard) {
           return sees_rate(guard.indicator) || sees_rate(guard.reset);
         });
}

bool sees_margin(const TangentialMode &mode) {
  return std::any_of(mode.guards.begin(), mode.guards.end(),
                     [](const Guard &guard) { return guard.indicator.margin != 0; });
}

// As a form: by value where the mode has none.
AffineForm normal_force_of(const Mode &mode) {
  return mode.affine ? mode.affine->force : AffineForm::force_along(0);
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

std::string why_no_friction(const ContactLaw &normal, const TangentialLaw &tangential) {
  if (normal.rigid() && !tangential.coefficients())
    return "rigid sides (coulomb without Damping constant is possible),";
  if (normal.may_pull())
    return "a normal force that may pull,";
  return "";
}

struct FrictionalLaw::Product {
  std::size_t n_normal = 0, n_own = 0; ///< internal states
  std::vector<Part> parts{};
  std::vector<Mode> modes{};
  std::vector<AffineLaw> forms{};

  void list_parts(const ContactLaw &normal, const TangentialLaw &tangential);
  void lead_guards(const Part &part, Mode &mode) const;
  void add_friction(const Part &part, const TangentialMode &own, Mode &mode, AffineLaw &of) const;
};

int FrictionalLaw::place(const std::vector<Part> &parts, int normal, int tangential) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part &part) {
    return part.normal == normal && (part.tangential == tangential || part.tangential == -1);
  });
  return static_cast<int>(found - parts.begin());
}

void FrictionalLaw::Product::list_parts(const ContactLaw &normal, const TangentialLaw &tangential) {
  for (int m = 0; m < static_cast<int>(normal.modes().size()); ++m) {
    const AffineForm force = normal_force_of(normal.modes()[static_cast<std::size_t>(m)]);
    const std::vector<TangentialMode> own = tangential.modes(force, n_normal);
    if (force.zero())
      parts.push_back({.normal = m});
    for (std::size_t t = 0; t < own.size() && !force.zero(); ++t)
      parts.push_back(
          {.normal = m, .tangential = static_cast<int>(t), .evaluated = own[t].evaluated});
  }
}

// Guards of the normal law: the friction goes on as it is where both modes have it, and begins or
// ends with the force; a spring that is let go relaxes.
void FrictionalLaw::Product::lead_guards(const Part &part, Mode &mode) const {
  const bool acts = part.tangential >= 0;
  for (Guard &guard : mode.guards) {
    guard.target = place(parts, guard.target, std::max(part.tangential, 0));
    const bool goes_on = parts[static_cast<std::size_t>(guard.target)].tangential >= 0;
    guard.by_slip = !acts && goes_on;
    if (!acts || goes_on || n_own == 0)
      continue;
    for (std::size_t i = guard.reset.size(); i < n_normal; ++i)
      guard.reset.push_back(internal_state(i));
    guard.reset.resize(n_normal + n_own);
  }
}

void FrictionalLaw::Product::add_friction(const Part &part, const TangentialMode &own, Mode &mode,
                                          AffineLaw &of) const {
  mode.name += ", " + own.name;
  mode.friction = own.friction;
  mode.holds_slip = own.holds_slip;
  mode.sees_force_rate = sees_rate(own);
  mode.limit = own.limit;
  mode.sees_margin = sees_margin(own);
  of.tangential_force = own.force;
  of.sliding_speed = own.sliding_speed;
  std::copy(own.internal_rate.begin(), own.internal_rate.end(),
            of.internal_rate.begin() + static_cast<std::ptrdiff_t>(n_normal));
  for (Guard guard : own.guards) {
    guard.target = place(parts, part.normal, guard.target);
    if (!guard.reset.empty())
      for (std::size_t i = 0; i < n_normal; ++i)
        guard.reset.insert(guard.reset.begin() + static_cast<std::ptrdiff_t>(i), internal_state(i));
    mode.guards.push_back(std::move(guard));
  }
}

FrictionalLaw::Product FrictionalLaw::multiply(const ContactLaw &normal,
                                               const TangentialLaw &tangential) {
  Product product{.n_normal = static_cast<std::size_t>(normal.n_internal()),
                  .n_own = tangential.internal_states().size()};
  product.list_parts(normal, tangential);
  for (const Part &part : product.parts) {
    Mode mode = normal.modes()[static_cast<std::size_t>(part.normal)];
    const AffineForm force = normal_force_of(mode);
    product.lead_guards(part, mode);
    AffineLaw &forms = product.forms.emplace_back(mode.affine.value_or(AffineLaw{}));
    forms.internal_rate.resize(product.n_normal + product.n_own);
    if (part.tangential >= 0)
      product.add_friction(
          part,
          tangential.modes(force, product.n_normal)[static_cast<std::size_t>(part.tangential)],
          mode, forms);
    if (part.evaluated)
      mode.affine.reset();
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
      forms_(std::move(product.forms)) {}

std::vector<InternalState> FrictionalLaw::internal_states() const {
  std::vector<InternalState> states = normal_->internal_states();
  for (InternalState &own : tangential_->internal_states())
    states.push_back(std::move(own));
  return states;
}

std::string FrictionalLaw::objection(int mode, const LocalState &state) const {
  return normal_->objection(parts_[static_cast<std::size_t>(mode)].normal, of_normal(state));
}

// A force that depends on the slip rate alone begins and ends with a jump.
std::optional<ForcePulse> FrictionalLaw::force_pulse(int mode) const {
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  const bool jumps =
      !forms_[static_cast<std::size_t>(mode)].tangential_force[0].tangential[0].zero();
  if (!tangential_->internal_states().empty() || jumps ||
      modes()[static_cast<std::size_t>(mode)].holds_slip)
    return std::nullopt;
  return normal_->force_pulse(part.normal);
}

double FrictionalLaw::impact_friction() const {
  return normal_->rigid()
             ? tangential_->coefficients().value_or(TangentialLaw::Coefficients{}).sliding
             : 0;
}

double FrictionalLaw::static_friction() const {
  return normal_->rigid()
             ? tangential_->coefficients().value_or(TangentialLaw::Coefficients{}).at_rest
             : 0;
}

LocalState FrictionalLaw::of_normal(const LocalState &state) const {
  LocalState part = state;
  part.internal = state.internal.first(static_cast<std::size_t>(normal_->n_internal()));
  return part;
}

int FrictionalLaw::mode_of(int normal, int tangential) const {
  return place(parts_, normal, tangential);
}

int FrictionalLaw::initial_mode(const LocalState &state) const {
  return mode_by_slip(mode_of(normal_->initial_mode(of_normal(state)), 0), state);
}

int FrictionalLaw::mode_by_slip(int mode, const LocalState &state) const {
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  return part.tangential < 0
             ? mode
             : mode_of(part.normal,
                       tangential_->mode_by_slip(part.tangential, state,
                                                 static_cast<std::size_t>(normal_->n_internal())));
}

void FrictionalLaw::leave(int mode, const LocalState &state, std::span<double> internal) const {
  const Part &part = parts_[static_cast<std::size_t>(mode)];
  if (part.tangential < 0 || !part.evaluated)
    return;
  const auto n_normal = static_cast<std::size_t>(normal_->n_internal());
  LawResponse response;
  normal_->evaluate(part.normal, of_normal(state), response);
  tangential_->leave(part.tangential, response.force, internal.subspan(n_normal));
}

} // namespace vibroimpact::contact
