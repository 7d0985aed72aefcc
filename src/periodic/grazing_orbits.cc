#include "periodic/grazing_orbits.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::periodic {

using continuation::Point;
using continuation::Transfer;

namespace {

constexpr double widest = 0.25;       // of a window, to either side [periods]
constexpr double farthest = 0.05;     // of the graze from the middle of its window [periods]
constexpr double same_instant = 1e-6; // [periods]; the end of a slip is a change itself

} // namespace

double GrazingOrbits::wrapped(double phase) const {
  const auto periods = static_cast<double>(section_at(0).multiple());
  return phase - std::floor(phase / periods) * periods;
}

GrazingFlow GrazingOrbits::flow(const Point &point) {
  const Section section = section_at(point.chart);
  const GrazingMaps maps = maps_.grazing(point.keys, window_);
  GrazingFlow flow = periodic::extend(maps, section, point.state, window_);
  if (std::abs(flow.touch - window_.position) > farthest)
    window_ = window_from(section.phase, section, flow, maps.map);
  return flow;
}

// From the phase on, which lies in the section or at its end. What has happened before comes again
// a section later, with a symmetry at the other contact. Half-way to the changes of the same
// contact the window ends.
GrazeWindow GrazingOrbits::window_from(double phase, const Section &section,
                                       const GrazingFlow &flow, const StroboscopicMap &map) const {
  const auto seen = [&](double at, std::size_t contact) {
    return at >= phase ? std::pair(at, contact)
                       : std::pair(at + section.length(), map.mirrored(section, contact));
  };
  GrazeWindow window = window_;
  std::tie(window.position, window.contact) = seen(flow.touch, window_.contact);
  window.begin = std::max(phase, window.position - widest);
  window.end = std::min(phase + section.length(), window.position + widest);
  for (const PatternEvent &event : flow.pattern.events) {
    const auto [at, contact] = seen(section.phase + event.time / map.period(), event.contact);
    const double middle = (at + window.position) / 2;
    if (contact != window.contact || event.from == event.to ||
        (window.stick && at > window.position - same_instant))
      continue;
    (at < window.position ? window.begin : window.end) =
        at < window.position ? std::max(window.begin, middle) : std::min(window.end, middle);
  }
  return window;
}

continuation::Evaluation GrazingOrbits::evaluate(const Point &point) {
  return flow(point).extension.smooth;
}

continuation::Extension GrazingOrbits::extend(const Point &point,
                                              const continuation::Graze & /*graze*/) {
  return flow(point).extension;
}

double GrazingOrbits::best_chart(const Point &point) {
  const double instant = flow(point).pattern.calmest_instant();
  return wrapped(point.chart + instant / maps_.at(point.keys).period());
}

Transfer GrazingOrbits::transfer(const Point &point, double chart) {
  const GrazingFlow whole = flow(point);
  const GrazingMaps maps = maps_.grazing(point.keys, window_);
  const Section section = section_at(point.chart);
  const double to = point.chart + wrapped(chart - point.chart);
  const Flow moved = flow_past(maps, point.chart, to, point.state, window_);
  window_ = window_from(to, section, whole, maps.map);
  for (double *phase : {&window_.begin, &window_.position, &window_.end})
    *phase += chart - to;
  return {.point = {.state = moved.state, .keys = point.keys, .chart = chart},
          .by_state = moved.by_state,
          .by_keys = moved.by_keys};
}

std::vector<double> GrazingOrbits::remembered() const {
  return {static_cast<double>(window_.contact), window_.begin, window_.position, window_.end};
}

void GrazingOrbits::remember(const std::vector<double> &numbers) {
  window_.contact = static_cast<std::size_t>(numbers.at(0));
  window_.begin = numbers.at(1);
  window_.position = numbers.at(2);
  window_.end = numbers.at(3);
}

} // namespace vibroimpact::periodic
