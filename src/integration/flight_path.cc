#include "integration/flight_path.h"

#include "common/error.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace vibroimpact::integration {

using model::ExponentialForm;

namespace {

// Value of a guard of the next phase for each value of the guard passed, where the two are
// proportional (up to the sign); 0 where they are not.
double proportion(const LinearRow &form, const LinearRow &passed) {
  const double constant = form.constant * form.constant;
  const double square = passed.row.squaredNorm() + passed.constant * passed.constant;
  const double product = form.row.dot(passed.row) + form.constant * passed.constant;
  const double size = form.row.squaredNorm() + constant;
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  const bool parallel = product * product >= (1 - rounding) * size * square;
  return parallel && square > 0 ? std::abs(product) / square : 0;
}

const contact::AffineForm &indicator(const Equations &equations, const FlightGuard &guard) {
  const contact::ContactLaw &law = *equations.contacts().pairs()[guard.contact].law;
  const auto mode = static_cast<std::size_t>(equations.modes()[guard.contact]);
  return law.modes()[mode].guards[guard.guard].indicator;
}

bool same_kind(const ExponentialForm::Term &a, const ExponentialForm::Term &b) {
  return (a.exponent.imag() != 0) == (b.exponent.imag() != 0);
}

bool same_exponents(const ExponentialForm::Term &a, const ExponentialForm::Term &b) {
  return a.exponent == b.exponent;
}

// As many of the same kind, term by term; constants are inputs where they are not zero.
template <typename SameTerm>
bool same(const std::vector<ExponentialForm> &one, const std::vector<ExponentialForm> &other,
          SameTerm same_term) {
  const auto constant = [](const ExponentialForm &form) {
    return !form.polynomial.empty() && form.polynomial[0] != 0;
  };
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [&](const ExponentialForm &a, const ExponentialForm &b) {
                      return a.polynomial.size() == b.polynomial.size() &&
                             constant(a) == constant(b) &&
                             std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(),
                                        b.terms.end(), same_term);
                    });
}

void set_modes(const std::vector<int> &modes, Equations &equations) {
  for (std::size_t c = 0; c < modes.size(); ++c)
    equations.set_mode(c, modes[c]);
}

} // namespace

FlightPath::FlightPath(Equations &equations, FlightStepper &stepper, double event_tolerance)
    : equations_(equations), stepper_(stepper), event_tolerance_(event_tolerance),
      last_event_(-std::numeric_limits<double>::infinity()) {}

void FlightPath::begin() {
  known_ = nullptr;
  aloft_ = false;
  last_event_ = -std::numeric_limits<double>::infinity();
}

void FlightPath::forget_exponentials() {
  for (auto &[modes, known] : phases_) {
    known.described = -1;
    known.phase.reset();
    known.ledger.reset();
    known.watched.reset();
    for (const std::unique_ptr<Transition> &transition : known.transitions)
      if (transition)
        transition->change.reset();
  }
}

double FlightPath::time_tolerance(double time) const {
  return std::max(event_tolerance_, 8 * std::numeric_limits<double>::epsilon() * std::abs(time));
}

// Phases hold the response to the inputs, whose frequencies may be others, or which may be others
// altogether.
void FlightPath::take_excitation() {
  const std::vector<ExponentialForm> &now = stepper_.sources();
  if (!same(now, sources_, same_kind))
    forget_exponentials();
  if (!same(now, sources_, same_exponents))
    ++excitation_;
  sources_ = now;
}

// For the present excitation, in the modes of the equations.
void FlightPath::describe(KnownPhase &known) {
  if (!known.forms && LinearSystem::holds(equations_)) {
    known.forms = std::make_unique<PhaseForms>(equations_);
    known.transitions.resize(known.forms->guards().size());
  }
  known.flies = known.forms && stepper_.describe(described_, inverse_);
  if (!known.flies)
    return;
  if (known.phase)
    known.phase->renew(described_);
  else
    known.phase = std::make_unique<FlightPhase>(*known.forms, described_, inverse_);
}

// Of the present modes of the equations.
FlightPath::KnownPhase &FlightPath::known_phase() {
  KnownPhase &known = phases_[equations_.modes()];
  if (known.described != excitation_)
    describe(known);
  known.described = excitation_;
  return known;
}

// To the phase beyond a guard of the present one. None where it is left to others: impacts and rest
// are for several contacts together.
FlightPath::Transition *FlightPath::transition(std::size_t guard) {
  const FlightGuard passed = known_->forms->guards()[guard];
  if (equations_.contacts().pairs()[passed.contact].law->rigid())
    return nullptr;
  std::unique_ptr<Transition> &known = known_->transitions[guard];
  if (!known)
    known = std::make_unique<Transition>(find_transition(passed));
  if (known->target->described != excitation_) {
    equations_.set_mode(passed.contact, passed.target);
    known_phase();
    set_modes(known_->forms->contact_modes(), equations_);
  }
  if (!known->target->flies)
    return nullptr;
  if (!known->change)
    known->change = std::make_unique<PhaseChange>(*known_->phase, guard, *known->target->phase);
  else if (known->excitation != excitation_)
    known->change->renew();
  known->excitation = excitation_;
  return known.get();
}

FlightPath::Transition FlightPath::find_transition(const FlightGuard &passed) {
  const LinearRow form = linear_row(equations_, passed.contact, indicator(equations_, passed));
  equations_.set_mode(passed.contact, passed.target);
  Transition transition{.target = &known_phase(), .proportion = {}};
  if (transition.target->forms)
    for (const FlightGuard &other : transition.target->forms->guards())
      transition.proportion.push_back(
          other.contact == passed.contact
              ? proportion(linear_row(equations_, other.contact, indicator(equations_, other)),
                           form)
              : 0);
  set_modes(known_->forms->contact_modes(), equations_);
  return transition;
}

void FlightPath::set_inputs(double time, const FlightPhase &phase, Amplitudes &amplitudes) const {
  const ExponentialBasis &basis = phase.basis();
  amplitudes.resize(basis.groups.size());
  std::size_t place = basis.n_modes();
  const auto put = [&](Complex amplitude) {
    amplitudes.real[place] = amplitude.real();
    amplitudes.imaginary[place++] = amplitude.imag();
  };
  if (!basis.inputs.empty() && basis.inputs.front().own)
    put(1);
  for (const ExponentialForm &source : sources_) {
    if (!source.polynomial.empty() && source.polynomial[0] != 0)
      put(source.polynomial[0]);
    for (const ExponentialForm::Term &term : source.terms) {
      const Complex now = term.amplitude * std::exp(term.exponent * (time - source.origin));
      put(term.exponent.imag() >= 0 ? now : std::conj(now));
    }
  }
}

// One that has just been passed is zero within what its location has left.
bool FlightPath::begin_guard(std::size_t guard, std::span<const ZeroGuard> zero) {
  const FlightGuard &place = known_->forms->guards()[guard];
  const bool was_zero = std::any_of(zero.begin(), zero.end(), [&](const ZeroGuard &passed) {
    return passed.contact == place.contact && passed.guard == place.guard;
  });
  if (!was_zero)
    return kernel_->value(guard) > kernel_->rounding(guard);
  kernel_->zero_at_start(guard);
  return kernel_->slope(guard) > 0;
}

bool FlightPath::take_off(double time, const Vector &state, std::span<const ZeroGuard> zero) {
  if (!stepper_.handles(time))
    return false;
  take_excitation();
  known_ = &known_phase();
  if (!known_->flies)
    return false;
  physical_ = state.head(known_->phase->size());
  set_inputs(time, *known_->phase, amplitudes_);
  changes_ = 0;
  known_->phase->find_modes(physical_, amplitudes_);
  kernel_->start(known_->phase->sums(), amplitudes_);
  origin_ = time;
  for (std::size_t g = 0; g < known_->forms->guards().size(); ++g)
    if (!begin_guard(g, zero))
      return false;
  return true;
}

// Makes what it takes to watch a phase, the modes of the equations being its. False: its energies
// cannot be told in closed form.
bool FlightPath::prepare_watch(KnownPhase &known) {
  if (!known.powers)
    known.powers = std::make_unique<PowerForms>(equations_);
  if (!known.powers->known())
    return false;
  if (!known.ledger)
    known.ledger =
        std::make_unique<FlightLedger>(*known.powers, known.phase->basis(), equations_.layout());
  else if (known.ledger_excitation != excitation_)
    known.ledger->renew();
  known.ledger_excitation = excitation_;
  if (known.wishes.watcher != company_->watcher->identity()) {
    std::vector<WatchedForm> forms;
    company_->watcher->watch(equations_, forms);
    known.wishes = {.watcher = company_->watcher->identity(), .forms = WatchedForms(forms)};
    known.watched.reset();
  }
  if (!known.watched)
    known.watched = std::make_unique<WatchedSums>(known.wishes.forms, known.phase->basis());
  else if (known.watched_excitation != excitation_)
    known.watched->renew();
  known.watched_excitation = excitation_;
  return true;
}

// A stretch is a part of a phase that is told as a whole.
bool FlightPath::begin_stretch(double time) {
  if (!company_) {
    kernel_->watch(nullptr);
    return true;
  }
  if (!prepare_watch(*known_))
    return false;
  kernel_->watch(known_->watched.get());
  stretch_ = kernel_->amplitudes();
  stretch_start_ = time;
  return true;
}

void FlightPath::end_stretch(double time, const Amplitudes &amplitudes) {
  if (!company_ || time <= stretch_start_)
    return;
  known_->ledger->add(stretch_, amplitudes, time - stretch_start_, *state_);
  company_->watcher->flown(equations_, stretch_start_, time);
}

// Tells of a contact change, which takes the equations to the modes after it. False, and nothing
// happens: the phase to come cannot be watched.
bool FlightPath::tell_change(double time, KnownPhase &next) {
  set_modes(next.forms->contact_modes(), equations_);
  const bool prepared = prepare_watch(next);
  set_modes(known_->forms->contact_modes(), equations_);
  if (!prepared)
    return false;
  const FlightGuard &passed = known_->forms->guards()[kernel_->guard()];
  end_stretch(time, kernel_->amplitudes_at_guard());
  known_->phase->rows(kernel_->amplitudes_at_guard(), rows_);
  state_->head(known_->phase->size()) = rows_.head(known_->phase->size());
  company_->change(time, passed.contact, passed.guard, *state_);
  return true;
}

// The new phase's guards of the contact that changed may be zero, and must rise then; all others
// must be positive beyond doubt.
bool FlightPath::begin_guards(const Transition &transition, std::size_t passed) {
  const double tolerance = time_tolerance(origin_);
  const double left = std::abs(kernel_->value_at_guard(passed));
  const std::vector<FlightGuard> &guards = transition.target->forms->guards();
  const std::size_t contact = known_->forms->guards()[passed].contact;
  for (std::size_t g = 0; g < guards.size(); ++g) {
    const double value = next_->value(g);
    const double slope = next_->slope(g);
    double noise = next_->rounding(g);
    if (guards[g].contact != contact) {
      if (value <= noise)
        return false;
      continue;
    }
    noise = std::max({noise, 2 * std::max(tolerance, kernel_->residual()) * std::abs(slope),
                      transition.proportion[g] * left});
    if (value < -noise || (value <= noise && slope <= 0))
      return false;
    if (value <= noise)
      next_->zero_at_start(g);
  }
  return true;
}

// Rounding turns the inputs that are carried along from phase to phase, so that they are taken from
// their closed form again and again. False: the change is left to others; the flight stands before
// it.
bool FlightPath::change_phase() {
  const double time = origin_ + kernel_->flown() + kernel_->time_to_guard();
  const std::size_t passed = kernel_->guard();
  if (time - last_event_ <= time_tolerance(time))
    return false;
  Transition *next = transition(passed);
  if (!next) {
    note_landing();
    return false;
  }
  const FlightPhase &target = *next->target->phase;
  next->change->apply(kernel_->amplitudes_at_guard(), amplitudes_);
  constexpr int carried_changes = 32;
  if (changes_ >= carried_changes)
    set_inputs(time, target, amplitudes_);
  next_->start(target.sums(), amplitudes_);
  if (!begin_guards(*next, passed) || (company_ && !tell_change(time, *next->target)))
    return false;
  note_residual();
  ++tally_.events;
  changes_ = changes_ < carried_changes ? changes_ + 1 : 0;
  last_event_ = origin_ = time;
  known_ = next->target;
  set_modes(known_->forms->contact_modes(), equations_);
  std::swap(kernel_, next_);
  begin_stretch(time);
  return true;
}

void FlightPath::note_landing() {
  const std::size_t passed = kernel_->guard();
  const FlightGuard &guard = known_->forms->guards()[passed];
  landing_ = {.contact = guard.contact,
              .guard = guard.guard,
              .residual = std::abs(kernel_->value_at_guard(passed)),
              .rate = kernel_->slope_at_guard(passed)};
  note_residual();
}

// Zero where the guard is below the rounding of its own evaluation: no instant is closer.
void FlightPath::note_residual() {
  const std::size_t passed = kernel_->guard();
  if (std::abs(kernel_->value_at_guard(passed)) > kernel_->rounding(passed))
    tally_.event_residual = std::max(tally_.event_residual, kernel_->residual());
}

void FlightPath::land(double time, const Amplitudes &amplitudes, Vector &state) {
  end_stretch(time, amplitudes);
  known_->phase->rows(amplitudes, rows_);
  state.head(known_->phase->size()) = rows_.head(known_->phase->size());
  if (!state.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(time) + " s");
}

bool FlightPath::fly(double &time, Vector &state, double limit, long most_events,
                     std::span<const ZeroGuard> zero, const FlightCompany *company) {
  company_ = company;
  state_ = &state;
  landing_.reset();
  if ((!aloft_ && !take_off(time, state, zero)) || !begin_stretch(time))
    return false;
  const double from = time;
  if (company_)
    limit = std::min(limit, from + known_->ledger->longest());
  FlightKernel::End end = FlightKernel::End::guard;
  while (end == FlightKernel::End::guard) {
    const long before = kernel_->pieces();
    end = kernel_->fly(limit - origin_);
    tally_.pieces += kernel_->pieces() - before;
    if (end == FlightKernel::End::guard && (most_events-- <= 0 || !change_phase()))
      break;
  }
  aloft_ = end == FlightKernel::End::limit;
  time = aloft_ ? limit : origin_ + kernel_->flown() + (landing_ ? kernel_->time_to_guard() : 0);
  land(time, landing_ ? kernel_->amplitudes_at_guard() : kernel_->amplitudes(), state);
  return time > from;
}

FlightPath::Tally FlightPath::take_tally() { return std::exchange(tally_, {}); }

} // namespace vibroimpact::integration
