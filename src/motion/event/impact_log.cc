#include "motion/event/impact_log.h"

#include "common/scalar.h"
#include "motion/interval/peak_force.h"

#include <algorithm>

namespace vibroimpact::motion {

namespace {
constexpr int pulse_samples = 4; // intervals per step
} // namespace

double Impact::restitution_coefficient() const {
  return approach_speed > 0 ? separation_speed / approach_speed : nan;
}

ImpactLog::ImpactLog(const contact::ContactSet &contacts, std::size_t pulses, bool instants)
    : contacts_(contacts), pulse_limit_(pulses), instants_(instants), tracks_(contacts.size()) {
  for (std::size_t c = 0; c < contacts.size(); ++c)
    forms_.push_back({.force = ForceForm{c}, .gap = GapForm{c}});
}

bool ImpactLog::in_contact(std::size_t contact, int mode) const {
  return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(mode)].in_contact;
}

void ImpactLog::record_pulse(Track &track, const StepView &view, std::size_t contact) const {
  const ContactCurves curves = view.contact_curves(contact);
  for (int i = 0; i <= pulse_samples; ++i) {
    const double tau = static_cast<double>(i) / pulse_samples;
    if (i == 0 && !track.pulses.time.empty() && track.pulses.time.back() == view.start())
      continue;
    track.pulses.time.push_back(view.start() + tau * view.length());
    track.pulses.force.push_back(view.force(contact, curves, tau));
    track.pulses.gap.push_back(curves.gap(tau));
  }
}

void ImpactLog::outputs(const Equations &equations, std::vector<Output> &list) {
  for (std::size_t c = 0; c < tracks_.size(); ++c)
    if (equations.mode(c).in_contact) {
      list.push_back({&forms_[c].force, &tracks_[c].force});
      list.push_back({&forms_[c].gap, &tracks_[c].gap});
    }
}

void ImpactLog::note_step(Track &track, const StepView &view, std::size_t contact) const {
  Impact &impact = track.current;
  if (instants_ && track.force.maximum > impact.peak_force)
    impact.peak_time = view.start() + sampled_peak_force(view, contact).tau * view.length();
  if (extrema_) {
    impact.force.include_force(view, contact);
    Bernstein overlap = view.gap(contact);
    overlap *= -1;
    impact.overlap.include(view, overlap);
  }
  if (track.pulses_begun > 0 && track.pulses_begun <= pulse_limit_)
    record_pulse(track, view, contact);
}

void ImpactLog::step(const StepView &view) {
  for (std::size_t c = 0; c < tracks_.size(); ++c)
    if (view.equations().mode(c).in_contact)
      note_step(tracks_[c], view, c);
  interval(view);
}

void ImpactLog::interval(const Interval &interval) {
  for (std::size_t c = 0; c < tracks_.size(); ++c)
    if (interval.equations().mode(c).in_contact)
      take_ranges(tracks_[c]);
}

void ImpactLog::take_ranges(Track &track) {
  Impact &impact = track.current;
  impact.peak_force = std::max(impact.peak_force, track.force.maximum);
  impact.maximum_penetration = std::max(impact.maximum_penetration, -track.gap.minimum);
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
                   .angle = event.angle,
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
  take_ranges(track);
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
