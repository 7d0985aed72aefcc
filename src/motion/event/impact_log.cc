#include "motion/event/impact_log.h"

#include "common/scalar.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>

namespace vibroimpact::motion {

namespace {
constexpr int samples = 4; // intervals per step
} // namespace

double Impact::restitution_coefficient() const {
  return approach_speed > 0 ? separation_speed / approach_speed : nan;
}

namespace {

// Around the largest sample: a maximum inside the interval next to an end shows in a difference
// that has shrunk to less than half of the one before (to a third, for a parabola).
bool may_peak_inside(const std::array<double, samples + 1> &values, int best) {
  if (best > 0 && best < samples)
    return true;
  const int next = best == 0 ? 1 : samples - 1;
  const int after = best == 0 ? 2 : samples - 2;
  return values[best] - values[next] < 0.5 * (values[next] - values[after]);
}

struct Peak {
  double force = 0; ///< [N]
  double tau = 0;   ///< in the step
};

Peak sampled_peak(const StepView &view, std::size_t contact) {
  const ContactCurves curves = view.contact_curves(contact);
  std::array<double, samples + 1> values{};
  for (int i = 0; i <= samples; ++i)
    values[i] = view.force(contact, curves, static_cast<double>(i) / samples);
  const auto best =
      static_cast<int>(std::max_element(values.begin(), values.end()) - values.begin());
  const Peak sample{.force = values[best], .tau = static_cast<double>(best) / samples};
  if (sample.force <= 0 || !may_peak_inside(values, best))
    return sample;
  const double lower = std::max(0, best - 1) / static_cast<double>(samples);
  const double upper = std::min(samples, best + 1) / static_cast<double>(samples);
  const auto minimum = boost::math::tools::brent_find_minima(
      [&](double tau) { return -view.force(contact, curves, tau); }, lower, upper, 26);
  return -minimum.second > sample.force ? Peak{-minimum.second, minimum.first} : sample;
}

} // namespace

double peak_force(const StepView &view, std::size_t contact) {
  const auto mode = static_cast<std::size_t>(view.equations().modes()[contact]);
  const contact::Mode &present = view.equations().contacts().pairs()[contact].law->modes()[mode];
  return present.affine ? view.indicator(contact, present.affine->force).maximum()
                        : sampled_peak(view, contact).force;
}

ImpactLog::ImpactLog(const contact::ContactSet &contacts, std::size_t pulses, bool instants)
    : contacts_(contacts), pulse_limit_(pulses), instants_(instants), tracks_(contacts.size()) {}

bool ImpactLog::in_contact(std::size_t contact, int mode) const {
  return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(mode)].in_contact;
}

void ImpactLog::record_pulse(Track &track, const StepView &view, std::size_t contact) const {
  const ContactCurves curves = view.contact_curves(contact);
  for (int i = 0; i <= samples; ++i) {
    const double tau = static_cast<double>(i) / samples;
    if (i == 0 && !track.pulses.time.empty() && track.pulses.time.back() == view.start())
      continue;
    track.pulses.time.push_back(view.start() + tau * view.length());
    track.pulses.force.push_back(view.force(contact, curves, tau));
    track.pulses.gap.push_back(curves.gap(tau));
  }
}

void ImpactLog::note_peak(Impact &impact, const StepView &view, std::size_t contact) const {
  const double peak = motion::peak_force(view, contact);
  if (!(peak > impact.peak_force))
    return;
  impact.peak_force = peak;
  if (instants_)
    impact.peak_time = view.start() + sampled_peak(view, contact).tau * view.length();
}

void ImpactLog::step(const StepView &view) {
  for (std::size_t c = 0; c < tracks_.size(); ++c) {
    Track &track = tracks_[c];
    if (!in_contact(c, view.equations().modes()[c]))
      continue;
    note_peak(track.current, view, c);
    track.current.maximum_penetration =
        std::max(track.current.maximum_penetration, -view.gap(c).minimum());
    if (extrema_) {
      track.current.force.include_force(view, c);
      Bernstein overlap = view.gap(c);
      overlap *= -1;
      track.current.overlap.include(view, overlap);
    }
    if (track.pulses_begun > 0 && track.pulses_begun <= pulse_limit_)
      record_pulse(track, view, c);
  }
}

void ImpactLog::add_forms(const Equations &equations, std::vector<MonitoredForm> &forms) {
  for (std::size_t c = 0; c < tracks_.size(); ++c)
    if (equations.mode(c).in_contact) {
      forms.push_back(monitored_force(equations, c, tracks_[c].force));
      forms.push_back(monitored_contact(equations, c, {.gap = 1}, tracks_[c].gap));
    }
}

void ImpactLog::part_done(const Equations &equations, double /*start*/, double /*end*/,
                          const Vector & /*state*/) {
  for (std::size_t c = 0; c < tracks_.size(); ++c)
    if (equations.mode(c).in_contact) {
      Impact &impact = tracks_[c].current;
      impact.peak_force = std::max(impact.peak_force, tracks_[c].force.maximum);
      impact.maximum_penetration = std::max(impact.maximum_penetration, -tracks_[c].gap.minimum);
    }
}

void ImpactLog::begin(Track &track, const ContactEvent &event) const {
  const StateLayout &layout = *event.layout;
  const auto contact = static_cast<Index>(event.contact);
  // A rigid impact has an impulse and takes energy at this very instant. What a change of mode
  // takes from a law of finite force belongs to the time before.
  const Vector &integrals =
      event.guard->action == contact::GuardAction::impact ? *event.before : *event.state;
  track.current = {.start_time = event.time,
                   .approach_speed = -event.gap_rate,
                   .peak_time = instants_ ? event.time : nan,
                   .impulse = -integrals[layout.impulse(contact)],
                   .dissipated_energy = -integrals[layout.contact_work(contact)],
                   .chatter_duration = event.chatter_duration};
  track.force = track.gap = {};
  track.complete = true;
  ++track.begun;
  ++track.pulses_begun;
}

void ImpactLog::finish(Track &track, const ContactEvent &event) const {
  if (!track.pulses.time.empty() && std::isfinite(track.pulses.time.back())) {
    track.pulses.time.push_back(nan);
    track.pulses.force.push_back(nan);
    track.pulses.gap.push_back(nan);
  }
  if (!track.complete)
    return;
  const StateLayout &layout = *event.layout;
  const auto contact = static_cast<Index>(event.contact);
  Impact &impact = track.current;
  impact.duration = event.time - impact.start_time;
  impact.separation_speed = event.gap_rate_after;
  impact.impulse += (*event.state)[layout.impulse(contact)];
  impact.dissipated_energy += (*event.state)[layout.contact_work(contact)];
  track.done.push_back(impact);
  track.complete = false;
}

void ImpactLog::end_record(double time, const Vector &state, const StateLayout &layout) {
  for (std::size_t c = 0; c < tracks_.size(); ++c) {
    if (!tracks_[c].complete)
      continue;
    Impact impact = tracks_[c].current;
    impact.duration = time - impact.start_time;
    impact.separation_speed = nan;
    impact.impulse += state[layout.impulse(static_cast<Index>(c))];
    impact.dissipated_energy += state[layout.contact_work(static_cast<Index>(c))];
    impact.finished = false;
    tracks_[c].done.push_back(impact);
  }
}

void ImpactLog::event(const ContactEvent &event) {
  Track &track = tracks_[event.contact];
  if (event.onset)
    begin(track, event);
  const bool over = event.onset || in_contact(event.contact, event.from);
  if (over && !in_contact(event.contact, event.to))
    finish(track, event);
}

void ImpactLog::clear() {
  for (Track &track : tracks_) {
    track.done.clear();
    track.begun = 0;
  }
}

void ImpactLog::start_afresh() {
  for (Track &track : tracks_)
    track = {};
}

} // namespace vibroimpact::motion
