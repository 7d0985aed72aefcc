#include "motion/phase/friction_routes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace vibroimpact::motion {

namespace {

using Resets = std::vector<PhaseForms::Reset>;

// A row of the state behind resets, as one of the state before.
LinearRow before_resets(LinearRow row, const Resets &resets) {
  const RowVector behind = row.row;
  for (const PhaseForms::Reset &reset : resets)
    row.row[reset.entry] = 0;
  for (const PhaseForms::Reset &reset : resets) {
    const double factor = behind[reset.entry];
    row.row += factor * reset.form.row;
    row.constant += factor * reset.form.constant;
  }
  return row;
}

// One after the other.
Resets chained(const Resets &first, const Resets &then) {
  Resets both;
  for (const PhaseForms::Reset &reset : then)
    both.push_back({.entry = reset.entry, .form = before_resets(reset.form, first)});
  for (const PhaseForms::Reset &reset : first)
    if (std::none_of(then.begin(), then.end(),
                     [&](const PhaseForms::Reset &later) { return later.entry == reset.entry; }))
      both.push_back(reset);
  return both;
}

// The form of one velocity without what is left of the slip rates that are held; `by_rates`: what
// these change it by, summed up from `sizes_by_rates`. What rounding leaves of terms that cancel is
// none.
PhaseForms::Reset stopped_velocity(const Equations &equations, Index entry,
                                   const RowVector &by_rates, const RowVector &sizes_by_rates) {
  constexpr double rounding = 1e-14;
  const ActiveConstraints &holding = equations.holding();
  const Index size = equations.layout().physical_size() +
                     3 * static_cast<Index>(equations.model().sources().size());
  LinearRow form{.row = RowVector::Unit(size, entry)};
  LinearRow sizes = form;
  for (Index k = 0; k < holding.size(); ++k) {
    const HeldDirection &held = holding.held(k);
    if (held.direction == 0)
      continue;
    const LinearRow rate =
        row_of_motion(equations, held.contact, contact::AffineForm::rate_along(held.direction));
    form.row -= by_rates[k] * rate.row;
    form.constant -= by_rates[k] * rate.constant;
    sizes.row += sizes_by_rates[k] * rate.row.cwiseAbs();
  }
  form.row = (form.row.array().abs() <= rounding * sizes.row.array()).select(0.0, form.row);
  return {.entry = entry, .form = std::move(form)};
}

Resets without_slip(const Equations &equations) {
  const ActiveConstraints &holding = equations.holding();
  const Matrix inverse = holding.forces(Matrix::Identity(holding.size(), holding.size()));
  const Matrix by_rates = holding.response() * inverse;
  const Matrix sizes = holding.response().cwiseAbs() * inverse.cwiseAbs();
  Resets resets;
  for (Index i = 0; i < by_rates.rows(); ++i)
    if (!sizes.row(i).isZero(0))
      resets.push_back(stopped_velocity(equations, equations.layout().velocity() + i,
                                        by_rates.row(i), sizes.row(i)));
  return resets;
}

// The part of an acceleration that constraint forces cancel, W M^-1 W^T F: sizes, entry by entry.
LinearRow sizes_of_holding(const Equations &equations, const LinearSystem &system,
                           const HeldDirection &held, const Resets &resets) {
  const ActiveConstraints &holding = equations.holding();
  const RowVector by_force =
      holding.rows().row(holding.place(held.contact, held.direction)).cwiseAbs() *
      holding.response().cwiseAbs();
  Resets sizes = resets;
  for (PhaseForms::Reset &reset : sizes) {
    reset.form.row = reset.form.row.cwiseAbs();
    reset.form.constant = std::abs(reset.form.constant);
  }
  return before_resets({.row = by_force * system.constraint_forces().rows.cwiseAbs(),
                        .constant = by_force.dot(system.constraint_forces().constants.cwiseAbs())},
                       sizes);
}

// What constraints that can be held leave of accelerations is far less than so many roundings.
constexpr double roundings_of_slip = 1e4;

} // namespace

// Goes through the modes behind the guard.
class FrictionRoutes::Finder {
public:
  Finder(Equations &equations, const LinearPhase &from, std::size_t guard)
      : equations_(equations), passed_(from.forms().guards()[guard]),
        law_(*equations.contacts().pairs()[passed_.contact].law),
        resets_(from.forms().resets(guard)) {}

  Ways find() {
    const int before = equations_.modes()[passed_.contact];
    const contact::Guard &guard = equations_.mode(passed_.contact).guards[passed_.guard];
    if (guard.by_slip)
      ways_.slip_rate =
          add_form(row_of_motion(equations_, passed_.contact, contact::AffineForm::rate_along(1)));
    for (int k = 0; k < 3; ++k)
      ways_.by_slip[static_cast<std::size_t>(k)] =
          enter(guard.by_slip ? by_slip(passed_.target, k - 1) : passed_.target);
    equations_.set_mode(passed_.contact, before);
    return std::move(ways_);
  }

private:
  const contact::Mode &mode_of(int mode) const {
    return law_.modes()[static_cast<std::size_t>(mode)];
  }

  int by_slip(int mode, double rate) const {
    return law_.mode_by_slip(mode, {.tangential = {{{.slip_rate = rate}}}});
  }

  std::size_t add_form(LinearRow row) {
    ways_.forms.push_back(std::move(row));
    return ways_.forms.size() - 1;
  }

  std::size_t add_route(int mode, Resets resets) {
    ways_.routes.push_back({.mode = mode, .resets = std::move(resets)});
    return ways_.routes.size() - 1;
  }

  // Into a mode straight behind the guard, once.
  std::size_t enter(int mode) {
    for (const auto &[entered, route] : entered_)
      if (entered == mode)
        return route;
    equations_.set_mode(passed_.contact, mode);
    const std::size_t route =
        mode_of(mode).holds_slip ? enter_stick(mode) : add_route(mode, resets_);
    entered_.emplace_back(mode, route);
    return route;
  }

  std::size_t enter_stick(int mode) {
    const Resets stopped = chained(resets_, without_slip(equations_));
    Stick stick{.to = add_route(mode, stopped)};
    const LinearSystem system = LinearSystem::of_modes(equations_);
    add_slides(system, stopped, mode, stick);
    stick.first_guard = ways_.forms.size();
    for (const contact::Guard &guard : mode_of(mode).guards)
      if (mode_of(guard.target).friction == contact::Friction::slip)
        add_guard(system, stopped, guard, stick);
    const std::size_t route = stick.to;
    ways_.stick = std::move(stick);
    return route;
  }

  // Where what else is held makes the sides slide all the same.
  void add_slides(const LinearSystem &system, const Resets &stopped, int mode, Stick &stick) {
    if (equations_.holding().size() < 2)
      return;
    LinearRow slides =
        before_resets(system.derivative(row_of_motion(equations_, passed_.contact,
                                                      contact::AffineForm::rate_along(1))),
                      stopped);
    const LinearRow sizes =
        sizes_of_holding(equations_, system, {.contact = passed_.contact, .direction = 1}, stopped);
    constexpr double left = roundings_of_slip * Equations::rounding_factor;
    slides.row = (slides.row.array().abs() <= left * sizes.row.array()).select(0.0, slides.row);
    if (std::abs(slides.constant) <= left * sizes.constant)
      slides.constant = 0;
    if (slides.row.isZero(0) && slides.constant == 0)
      return;
    stick.slides = add_form(std::move(slides));
    stick.slide_backward = add_route(by_slip(mode, -1), stopped);
    stick.slide_forward = add_route(by_slip(mode, 1), stopped);
  }

  void add_guard(const LinearSystem &system, const Resets &stopped, const contact::Guard &guard,
                 Stick &stick) {
    add_form(before_resets(system.row(equations_, passed_.contact, guard.indicator), stopped));
    Resets then;
    const Index first = equations_.layout().internal() +
                        equations_.contacts().pairs()[passed_.contact].internal_offset;
    for (std::size_t i = 0; i < guard.reset.size(); ++i)
      then.push_back({.entry = first + static_cast<Index>(i),
                      .form = system.row(equations_, passed_.contact, guard.reset[i])});
    stick.behind_guards.push_back(add_route(guard.target, chained(stopped, then)));
  }

  Equations &equations_;
  const PhaseGuard passed_;
  const contact::ContactLaw &law_;
  const Resets &resets_;
  std::vector<std::pair<int, std::size_t>> entered_{}; ///< modes with their routes
  Ways ways_{};
};

FrictionRoutes::FrictionRoutes(Equations &equations, const LinearPhase &from,
                               const ExactPhase &phase, std::size_t guard)
    : ways_(Finder(equations, from, guard).find()), forms_(phase, ways_.forms) {}

// Straight behind the guard; slip rates below rounding are none.
std::size_t FrictionRoutes::first_route() const {
  if (!ways_.slip_rate)
    return ways_.by_slip[1];
  const double rate = forms_.value(*ways_.slip_rate);
  if (std::abs(rate) <= forms_.hidden(*ways_.slip_rate))
    return ways_.by_slip[1];
  return ways_.by_slip[rate > 0 ? 2 : 0];
}

// Whether the sides stick is decided by the force that it takes. Sides that cannot slide by
// themselves follow what moves them.
std::size_t FrictionRoutes::lead_on() const {
  const Stick &stick = *ways_.stick;
  if (stick.slides) {
    const double slides = forms_.value(*stick.slides);
    if (std::abs(slides) > roundings_of_slip * forms_.hidden(*stick.slides))
      return slides > 0 ? stick.slide_forward : stick.slide_backward;
  }
  for (std::size_t g = 0; g < stick.behind_guards.size(); ++g)
    if (forms_.value(stick.first_guard + g) < -forms_.hidden(stick.first_guard + g))
      return stick.behind_guards[g];
  return stick.to;
}

std::size_t FrictionRoutes::choose(const double *amplitudes, const double *rounding) {
  if (forms_.size() > 0)
    forms_.evaluate(amplitudes, rounding);
  const std::size_t route = first_route();
  return ways_.stick && ways_.stick->to == route ? lead_on() : route;
}

} // namespace vibroimpact::motion
