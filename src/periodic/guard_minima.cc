#include "periodic/guard_minima.h"

#include "periodic/open_contact.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

namespace vibroimpact::periodic {

using contact::ContactLaw;
using contact::Guard;
using motion::Bernstein;

namespace {

// Where a polynomial has minima inside the step, which may last for a large part of the period:
// where its derivative changes its sign between neighbouring instants.
std::vector<double> minima_of(const Bernstein &curve) {
  constexpr int parts = 16;
  const Bernstein slope = curve.derivative();
  std::vector<double> minima;
  for (int i = 0; i < parts; ++i) {
    const double from = static_cast<double>(i) / parts, to = static_cast<double>(i + 1) / parts;
    const double before = slope(from), after = slope(to);
    if (!(before < 0 && after >= 0))
      continue;
    std::uintmax_t most = 60;
    const auto [low, high] =
        boost::math::tools::toms748_solve([&](double tau) { return slope(tau); }, from, to, before,
                                          after, boost::math::tools::eps_tolerance<double>(), most);
    minima.push_back((low + high) / 2);
  }
  return minima;
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
      for (const double tau : minima_of(curve)) {
        const double time = view.start() + tau * view.length();
        minima_.push_back({.contact = c,
                           .mode = mode,
                           .guard = g,
                           .time = time,
                           .begin = time,
                           .end = time,
                           .value = curve(tau)});
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
