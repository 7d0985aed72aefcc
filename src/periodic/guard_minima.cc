#include "periodic/guard_minima.h"

#include "periodic/open_contact.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::periodic {

using contact::ContactLaw;
using contact::Guard;
using motion::Bernstein;

namespace {

// Where a polynomial has a minimum inside the step.
std::optional<double> minimum_of(const Bernstein &curve) {
  Bernstein falling = curve.derivative();
  if (!(falling.start() < 0 && falling.end() >= 0))
    return std::nullopt;
  return (falling *= -1).first_down_crossing();
}

} // namespace

void MinimumObserver::step(const motion::StepView &view) {
  const motion::Equations &equations = view.equations();
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const ContactLaw &law = *contacts_.pairs()[c].law;
    const int mode = equations.modes()[c];
    const std::vector<Guard> &guards = law.modes()[static_cast<std::size_t>(mode)].guards;
    for (std::size_t g = 0; !equations.mode(c).in_contact && g < guards.size(); ++g) {
      if (!closes(law, guards[g]))
        continue;
      const Bernstein curve = view.indicator(c, guards[g].indicator);
      if (const std::optional<double> tau = minimum_of(curve)) {
        const double time = view.start() + *tau * view.length();
        minima_.push_back({.contact = c,
                           .mode = mode,
                           .guard = g,
                           .time = time,
                           .begin = time,
                           .end = time,
                           .value = curve(*tau)});
      }
    }
  }
}

void MinimumObserver::event(const motion::ContactEvent &event) {
  const std::vector<contact::Mode> &modes = contacts_.pairs()[event.contact].law->modes();
  const auto in_contact = [&](int mode) {
    return modes[static_cast<std::size_t>(mode)].in_contact;
  };
  if (event.onset) {
    const std::vector<Guard> &guards = modes[static_cast<std::size_t>(event.from)].guards;
    if (in_contact(event.to))
      closed_.push_back(minima_.size());
    minima_.push_back({.contact = event.contact,
                       .mode = event.from,
                       .guard = static_cast<std::size_t>(event.guard - guards.data()),
                       .time = event.time,
                       .begin = event.time,
                       .end = event.time,
                       .value = std::abs(event.gap_rate),
                       .touched = true});
    return;
  }
  const auto closed = std::find_if(closed_.begin(), closed_.end(), [&](std::size_t place) {
    return minima_[place].contact == event.contact;
  });
  if (closed == closed_.end() || in_contact(event.to))
    return;
  GuardMinimum &minimum = minima_[*closed];
  minimum.end = event.time;
  minimum.time = (minimum.begin + minimum.end) / 2;
  closed_.erase(closed);
}

} // namespace vibroimpact::periodic
