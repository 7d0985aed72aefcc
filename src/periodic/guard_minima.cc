#include "periodic/guard_minima.h"

#include "common/zero.h"
#include "periodic/open_contact.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

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
    if (before < 0 && after >= 0)
      minima.push_back(zero_between(std::cref(slope), from, to));
  }
  return minima;
}

// Its place in a mode; none: the motion goes by another law, which overlooks guards.
std::optional<std::size_t> place_of(const Guard *guard, const contact::Mode &mode) {
  for (std::size_t g = 0; g < mode.guards.size(); ++g)
    if (&mode.guards[g] == guard)
      return g;
  return std::nullopt;
}

} // namespace

void MinimumObserver::step(const motion::StepView &view) {
  const motion::Equations &equations = view.equations();
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const ContactLaw &law = *contacts_.pairs()[c].law;
    const int mode = equations.modes()[c];
    const std::vector<Guard> &guards = law.modes()[static_cast<std::size_t>(mode)].guards;
    const bool closed = equations.mode(c).in_contact;
    for (std::size_t g = 0; g < guards.size(); ++g)
      if (closed || closes(law, guards[g]))
        note_minima(view, {c, mode, g}, closed);
  }
}

void MinimumObserver::note_minima(const motion::StepView &view, const Place &place,
                                  bool in_contact) {
  const auto &[contact, mode, guard] = place;
  const ContactLaw &law = *contacts_.pairs()[contact].law;
  const Bernstein curve =
      view.indicator(contact, law.modes()[static_cast<std::size_t>(mode)].guards[guard].indicator);
  for (const double tau : minima_of(curve)) {
    const double time = view.start() + tau * view.length();
    minima_.push_back({.contact = contact,
                       .mode = mode,
                       .guard = guard,
                       .in_contact = in_contact,
                       .time = time,
                       .begin = time,
                       .end = time,
                       .value = curve(tau)});
  }
  if (!in_contact)
    return;
  Seen &seen = seen_[place];
  for (const double tau : {0.0, 0.5, 1.0})
    seen.largest = std::max(seen.largest, std::abs(curve(tau)));
  seen.rate = curve.derivative()(1) / view.length();
}

void MinimumObserver::event(const motion::ContactEvent &event) {
  const contact::Mode &from =
      contacts_.pairs()[event.contact].law->modes()[static_cast<std::size_t>(event.from)];
  const auto guard = place_of(event.guard, from);
  if (in_contact(event.contact, event.to))
    come_back(event);
  for (SlipEnd &end : slip_ends_)
    if (end.contact == event.contact && end.next == end.time)
      end.next = event.time;
  if (guard && from.friction == contact::Friction::slip)
    end_slip(event, *guard);
  if (guard && from.in_contact)
    leave(event, *guard);
  if (guard && event.onset)
    touch(event, *guard);
  else if (from.in_contact && !in_contact(event.contact, event.to))
    part(event);
}

void MinimumObserver::touch(const motion::ContactEvent &event, std::size_t guard) {
  if (in_contact(event.contact, event.to))
    closed_.push_back(minima_.size());
  minima_.push_back({.contact = event.contact,
                     .mode = event.from,
                     .guard = guard,
                     .time = event.time,
                     .begin = event.time,
                     .end = event.time,
                     .value = std::abs(event.gap_rate),
                     .passed = true});
}

void MinimumObserver::leave(const motion::ContactEvent &event, std::size_t guard) {
  const auto seen = seen_.find({event.contact, event.from, guard});
  if (seen == seen_.end())
    return;
  left_.push_back(minima_.size());
  minima_.push_back({.contact = event.contact,
                     .mode = event.from,
                     .guard = guard,
                     .in_contact = true,
                     .time = event.time,
                     .begin = event.time,
                     .end = event.time,
                     .value = std::abs(seen->second.rate),
                     .passed = true});
}

void MinimumObserver::end_slip(const motion::ContactEvent &event, std::size_t guard) {
  const ContactLaw &law = *contacts_.pairs()[event.contact].law;
  const auto &modes = law.modes();
  const int stick = modes[static_cast<std::size_t>(event.from)].guards[guard].target;
  const contact::Mode &held = modes[static_cast<std::size_t>(stick)];
  if (!held.holds_slip || law.n_tangential() != 1)
    return;
  for (std::size_t g = 0; g < held.guards.size(); ++g)
    if (held.guards[g].target != event.from &&
        modes[static_cast<std::size_t>(held.guards[g].target)].friction == contact::Friction::slip)
      slip_ends_.push_back({.contact = event.contact,
                            .mode = event.from,
                            .guard = guard,
                            .stick = stick,
                            .slips_on = g,
                            .time = event.time,
                            .next = event.time});
}

void MinimumObserver::end_of(std::vector<std::size_t> &open, std::vector<std::size_t>::iterator at,
                             double time) {
  if (at == open.end())
    return;
  GuardMinimum &minimum = minima_[*at];
  minimum.end = time;
  minimum.time = (minimum.begin + minimum.end) / 2;
  open.erase(at);
}

void MinimumObserver::part(const motion::ContactEvent &event) {
  const auto closed = std::find_if(closed_.begin(), closed_.end(), [&](std::size_t place) {
    return minima_[place].contact == event.contact;
  });
  if (closed == closed_.end())
    parted_.try_emplace(event.contact, event.time);
  end_of(closed_, closed, event.time);
}

void MinimumObserver::come_back(const motion::ContactEvent &event) {
  end_of(left_,
         std::find_if(left_.begin(), left_.end(),
                      [&](std::size_t place) {
                        return minima_[place].contact == event.contact &&
                               minima_[place].mode == event.to;
                      }),
         event.time);
}

bool MinimumObserver::lasts(const GuardMinimum &minimum) const {
  const auto place = static_cast<std::size_t>(&minimum - minima_.data());
  return std::find(left_.begin(), left_.end(), place) != left_.end() ||
         std::find(closed_.begin(), closed_.end(), place) != closed_.end();
}

std::optional<double> MinimumObserver::first_parting(std::size_t contact) const {
  const auto parted = parted_.find(contact);
  return parted == parted_.end() ? std::nullopt : std::optional(parted->second);
}

double MinimumObserver::largest(const GuardMinimum &minimum) const {
  const auto seen = seen_.find({minimum.contact, minimum.mode, minimum.guard});
  return seen == seen_.end() ? 0 : seen->second.largest;
}

} // namespace vibroimpact::periodic
