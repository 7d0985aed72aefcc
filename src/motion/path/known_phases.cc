#include "motion/path/known_phases.h"

#include "common/memory.h"

#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {

constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

// Value of a guard of the next phase for each value of the guard passed, where the two are
// proportional (up to the sign); 0 where they are not.
double proportion(const LinearRow &form, const LinearRow &passed) {
  const double constant = form.constant * form.constant;
  const double square = passed.row.squaredNorm() + passed.constant * passed.constant;
  const double product = form.row.dot(passed.row) + form.constant * passed.constant;
  const double size = form.row.squaredNorm() + constant;
  const bool parallel = product * product >= (1 - 64 * rounding_unit) * size * square;
  return parallel && square > 0 ? std::abs(product) / square : 0;
}

const contact::AffineForm &indicator(const Equations &equations, const PhaseGuard &guard) {
  const contact::ContactLaw &law = *equations.contacts().pairs()[guard.contact].law;
  const auto mode = static_cast<std::size_t>(equations.modes()[guard.contact]);
  return law.modes()[mode].guards[guard.guard].indicator;
}

} // namespace

std::size_t ContactPart::bytes() const {
  return contact->bytes() + (work ? work->bytes() : 0) + observed.bytes();
}

std::size_t Transition::bytes() const {
  std::size_t sum = bytes_of(proportion) + (change ? change->bytes() : 0);
  for (const auto &[mode, transition] : behind)
    sum += transition->bytes();
  for (const auto &[mode, contact] : contacts)
    sum += contact ? contact->bytes() : 0;
  return sum + (routes ? routes->bytes() : 0);
}

std::size_t KnownPhase::bytes() const {
  std::size_t sum = bytes_of(transitions);
  for (const auto &transition : transitions)
    sum += transition ? transition->bytes() : 0;
  return sum + observed.bytes();
}

void KnownPhase::forget(const LinearPhase &other) {
  const auto leads_there = [&](const std::unique_ptr<Transition> &transition) {
    return transition && transition->target && &transition->target->linear == &other;
  };
  for (std::unique_ptr<Transition> &transition : transitions)
    if (leads_there(transition))
      transition.reset();
    else if (transition)
      std::erase_if(transition->behind, [&](const auto &at) { return leads_there(at.second); });
}

void KnownPhases::set_modes(const std::vector<int> &modes) {
  for (std::size_t c = 0; c < modes.size(); ++c)
    equations_.set_mode(c, modes[c]);
}

bool KnownPhases::known() const {
  const LinearPhase *const linear = phases_.find();
  return linear && linear->forms().guard_forms().products;
}

KnownPhase *KnownPhases::present() {
  return known() ? &phases_.present()->part<KnownPhase>() : nullptr;
}

// Under the present excitation.
void KnownPhases::renew(KnownPhase &from, Transition &transition,
                        const std::vector<PhaseForms::Reset> &resets) {
  const long excitation = phases_.excitation().generation();
  if (transition.excitation == excitation)
    return;
  transition.excitation = excitation;
  transition.target->phase().take(phases_.excitation());
  if (transition.change)
    transition.change->renew();
  else
    transition.change =
        std::make_unique<ExactChange>(from.phase(), resets, transition.target->phase());
}

Transition *KnownPhases::transition(KnownPhase &from, std::size_t guard) {
  std::unique_ptr<Transition> &known = from.transitions[guard];
  if (!known)
    known = std::make_unique<Transition>(find_transition(from, from.guards()[guard]));
  if (!known->target)
    return nullptr;
  renew(from, *known, from.linear.forms().resets(guard));
  return known.get();
}

// Where friction begins in a circular gap, none of the modes beyond is linear.
Transition KnownPhases::find_transition(const KnownPhase &from, const PhaseGuard &passed) {
  const contact::ContactPair &pair = equations_.contacts().pairs()[passed.contact];
  if (pair.law->rigid() || (pair.circle && begins_friction(from, passed)))
    return {};
  set_modes_of(from);
  const LinearRow form = linear_row(equations_, passed.contact, indicator(equations_, passed));
  equations_.set_mode(passed.contact, passed.target);
  Transition transition{.target = present(), .proportion = {}};
  if (transition.target)
    for (const PhaseGuard &other : transition.target->guards())
      transition.proportion.push_back(
          proportion(linear_row(equations_, other.contact, indicator(equations_, other)), form));
  set_modes_of(from);
  return transition;
}

bool KnownPhases::begins_friction(const KnownPhase &from, const PhaseGuard &passed) const {
  const auto mode = static_cast<std::size_t>(from.linear.forms().contact_modes()[passed.contact]);
  const contact::ContactLaw &law = *equations_.contacts().pairs()[passed.contact].law;
  return law.modes()[mode].guards[passed.guard].by_slip;
}

// That of the guard, or where friction begins the one by what the sides slide at.
int KnownPhases::mode_beyond(KnownPhase &from, std::size_t guard, double time,
                             const double *amplitudes) {
  const PhaseGuard &passed = from.guards()[guard];
  if (!begins_friction(from, passed))
    return passed.target;
  const contact::ContactLaw &law = *equations_.contacts().pairs()[passed.contact].law;
  set_modes_of(from);
  state_.setZero(equations_.layout().size());
  from.phase().state(amplitudes, state_.data());
  return law.mode_by_slip(
      passed.target,
      equations_.local_state(passed.contact, time, ConstVectorView(state_.data(), state_.size())));
}

ContactPart *KnownPhases::contact_beyond(KnownPhase &from, std::size_t guard, double time,
                                         const double *amplitudes) {
  const int mode = mode_beyond(from, guard, time, amplitudes);
  const auto [known, unknown] = from.transitions[guard]->contacts.try_emplace(mode);
  if (unknown) {
    set_modes_of(from);
    const std::size_t kind = guard + from.guards().size() * static_cast<std::size_t>(mode);
    std::shared_ptr<TaughtContact> &taught = from.linear.taught(kind);
    if (!taught)
      taught = std::make_shared<TaughtContact>();
    if (auto contact =
            PhaseEpisode::create(equations_, from.linear, guard, mode, tolerance_, taught))
      known->second = std::make_unique<ContactPart>(ContactPart{.contact = std::move(contact)});
  }
  return known->second.get();
}

Transition *KnownPhases::behind(KnownPhase &from, std::size_t guard, const PhaseEpisode &contact) {
  const int mode = contact.mode_after();
  if (mode == from.linear.forms().contact_modes()[contact.contact()])
    return nullptr;
  std::unique_ptr<Transition> &behind =
      from.transitions[guard]->behind[static_cast<std::size_t>(mode)];
  if (!behind)
    behind = std::make_unique<Transition>(lead_to(from, contact.contact(), mode));
  static const std::vector<PhaseForms::Reset> none;
  renew(from, *behind, none);
  return behind.get();
}

// To the phase with another mode of one contact. Leaves the equations as they are.
Transition KnownPhases::lead_to(const KnownPhase &from, std::size_t contact, int mode) {
  const std::vector<int> before = equations_.modes();
  set_modes_of(from);
  equations_.set_mode(contact, mode);
  Transition transition{.target = present(), .proportion = {}};
  set_modes(before);
  return transition;
}

FrictionRoutes &KnownPhases::friction_routes(KnownPhase &from, std::size_t guard) {
  std::unique_ptr<Transition> &known = from.transitions[guard];
  if (!known)
    known = std::make_unique<Transition>();
  const long excitation = phases_.excitation().generation();
  if (!known->routes) {
    set_modes_of(from);
    known->routes = std::make_unique<FrictionRoutes>(equations_, from.linear, from.phase(), guard);
  } else if (known->excitation != excitation) {
    known->routes->renew();
  }
  known->excitation = excitation;
  return *known->routes;
}

Transition *KnownPhases::friction_transition(KnownPhase &from, std::size_t guard,
                                             const double *amplitudes, const double *rounding,
                                             const FrictionRoutes::Route *&route) {
  FrictionRoutes &routes = friction_routes(from, guard);
  const std::size_t chosen = routes.choose(amplitudes, rounding);
  route = &routes.route(chosen);
  std::unique_ptr<Transition> &behind = from.transitions[guard]->behind[chosen];
  if (!behind)
    behind = std::make_unique<Transition>(lead_to(from, from.guards()[guard].contact, route->mode));
  if (!behind->target)
    return nullptr;
  renew(from, *behind, route->resets);
  return behind.get();
}

} // namespace vibroimpact::motion
