#include "analyses/derivatives/extreme_search.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>

namespace vibroimpact::analyses {

using motion::Bernstein;
using motion::StepView;

namespace {

constexpr int step_samples = 32;  // intervals of a step; polynomials are of degree nine at most
constexpr double close_by = 1e-3; // of a step
constexpr int all_bits = std::numeric_limits<double>::digits / 2;

struct Largest {
  double tau = 0, value = 0;
};

template <class Curve> Largest largest_of(const Curve &curve) {
  std::array<double, step_samples + 1> values{};
  for (int i = 0; i <= step_samples; ++i)
    values[static_cast<std::size_t>(i)] = curve(static_cast<double>(i) / step_samples);
  const auto best = std::max_element(values.begin(), values.end()) - values.begin();
  const double middle = static_cast<double>(best) / step_samples, width = 1.0 / step_samples;
  const auto inside = boost::math::tools::brent_find_minima(
      [&](double tau) { return -curve(tau); }, std::max(0.0, middle - width),
      std::min(1.0, middle + width), all_bits);
  const double at_sample = values[static_cast<std::size_t>(best)];
  if (-inside.second > at_sample)
    return {inside.first, -inside.second};
  return {middle, at_sample};
}

void keep(const std::vector<Extreme *> &extremes, const StepView &view, const Largest &found) {
  using Place = Extreme::Place;
  const Place place = found.tau == 0   ? Place::after_event
                      : found.tau == 1 ? Place::before_event
                                       : Place::inside;
  const double time = found.tau == 1 ? view.end() : view.start() + found.tau * view.length();
  const double aside = (found.tau > 0.5 ? -close_by : close_by) * view.length();
  for (Extreme *extreme : extremes)
    if (found.value > extreme->value)
      *extreme = {.value = found.value, .time = time, .beside = time + aside, .place = place};
}

// Values are equal to half of their digits within 1e-8 of their maximum; its slope has a simple
// zero.
double sharpened(const Bernstein &curve, double tau) {
  const Bernstein slope = curve.derivative(), curvature = slope.derivative();
  for (int i = 0; i < 3; ++i)
    if (const double change = -slope(tau) / curvature(tau); std::abs(change) < 1e-6)
      tau = std::clamp(tau + change, 0.0, 1.0);
  return tau;
}

Bernstein reversed(Bernstein curve) {
  curve *= -1;
  return curve;
}

} // namespace

ExtremeSearch::ExtremeSearch(const System &system, const std::vector<Observable> &quantities)
    : largest(quantities.size()), smallest(quantities.size()), forces(system.contacts.size()),
      impacts(system.contacts.size()), approach_speeds(system.contacts.size()),
      log(system.contacts, 0), system_(system), quantities_(quantities),
      present_(system.contacts.size()), complete_(system.contacts.size(), 0) {}

void ExtremeSearch::note(const std::vector<Extreme *> &extremes, const StepView &view,
                         const Bernstein &curve) const {
  const double bound = curve.maximum();
  if (std::none_of(extremes.begin(), extremes.end(),
                   [&](const Extreme *extreme) { return bound > extreme->value; }))
    return;
  Largest found = largest_of(curve);
  if (found.tau > 0 && found.tau < 1)
    found.tau = sharpened(curve, found.tau);
  keep(extremes, view, found);
}

void ExtremeSearch::take_interval(const StepView &view) {
  const double next_break = view.equations().source_break();
  const bool from_break = !intervals.empty() && next_break != next_break_;
  const bool from_event =
      intervals.empty() || (!events.empty() && events.back() >= intervals.back().end);
  next_break_ = next_break;
  breaks = breaks || from_break;
  if (from_break || from_event)
    intervals.push_back(
        {.start = view.start(), .modes = view.equations().modes(), .from_break = !from_event});
}

void ExtremeSearch::step(const StepView &view) {
  log.step(view);
  take_interval(view);
  intervals.back().end = view.end();
  ++intervals.back().steps;
  for (std::size_t i = 0; i < quantities_.size(); ++i) {
    const Bernstein along_step = curve(quantities_[i], view), mirror = reversed(along_step);
    note({&largest[i]}, view, along_step);
    note({&smallest[i]}, view, mirror);
  }
  for (std::size_t c = 0; c < present_.size(); ++c)
    if (in_contact(view, c))
      note_contact(view, c);
}

void ExtremeSearch::note_contact(const StepView &view, std::size_t contact) {
  const Bernstein overlap = reversed(view.gap(contact));
  note({&present_[contact].overlap}, view, overlap);
  const std::vector<Extreme *> extremes{&present_[contact].force, &forces[contact]};
  const motion::Equations &equations = view.equations();
  if (const contact::Mode &mode = equations.mode(contact); mode.affine) {
    note(extremes, view, view.indicator(contact, mode.affine->force));
  } else {
    const motion::ContactCurves curves = view.contact_curves(contact);
    keep(extremes, view, largest_of([&](double tau) { return view.force(contact, curves, tau); }));
  }
}

void ExtremeSearch::event(const motion::ContactEvent &event) {
  log.event(event);
  events.push_back(event.time);
  const std::size_t c = event.contact;
  const auto touches = [&](int mode) {
    return system_.contacts.pairs()[c].law->modes()[static_cast<std::size_t>(mode)].in_contact;
  };
  if (event.onset) {
    approach_speeds[c].push_back(-event.gap_rate);
    present_[c] = {};
    complete_[c] = 1;
  }
  if ((event.onset || touches(event.from)) && !touches(event.to) && complete_[c]) {
    impacts[c].push_back(present_[c]);
    complete_[c] = 0;
  }
}

void ExtremeSearch::end(const motion::Trajectory &trajectory) {
  log.end_record(trajectory.time(), trajectory.state(), trajectory.layout());
  for (std::size_t c = 0; c < present_.size(); ++c)
    if (complete_[c])
      impacts[c].push_back(present_[c]);
  settle_places();
}

// Most steps end where nothing happens.
void ExtremeSearch::settle_places() {
  const auto settle = [&](Extreme &extreme) {
    if (!std::binary_search(events.begin(), events.end(), extreme.time))
      extreme.place = Extreme::Place::inside;
  };
  for (std::vector<Extreme> *list : {&largest, &smallest, &forces})
    std::for_each(list->begin(), list->end(), settle);
  for (std::vector<ImpactExtremes> &list : impacts)
    for (ImpactExtremes &impact : list) {
      settle(impact.force);
      settle(impact.overlap);
    }
}

} // namespace vibroimpact::analyses
