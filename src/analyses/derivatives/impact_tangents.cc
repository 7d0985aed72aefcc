#include "analyses/derivatives/impact_tangents.h"

#include <boost/math/quadrature/gauss.hpp>

namespace vibroimpact::analyses {

namespace {

using GaussRule = boost::math::quadrature::gauss<double, 20>;

constexpr long steps_in_panel = 2;

/// Powers u^(k/4) of the time u since either end are polynomials of s in
/// u = s^4 (35 - 84 s + 70 s^2 - 20 s^3), whose rate is 140 s^3 (1 - s)^3.
double graded(double s) { return s * s * s * s * (35 + s * (-84 + s * (70 - 20 * s))); }
double grading(double s) { return 140 * std::pow(s * (1 - s), 3); }

void add_panel(std::vector<IntegrationNode> &nodes, std::size_t interval,
               const SmoothInterval &whole, double start, double length) {
  const auto add = [&](double x, double weight) {
    const double s = 0.5 * (1 + x);
    const double time = start + graded(s) * length;
    nodes.push_back({.time = time,
                     .weight = 0.5 * weight * grading(s) * length,
                     .place = (time - whole.start) / (whole.end - whole.start),
                     .interval = interval});
  };
  const std::size_t half = GaussRule::abscissa().size();
  for (std::size_t i = half; i-- > 0;)
    add(-GaussRule::abscissa()[i], GaussRule::weights()[i]);
  for (std::size_t i = 0; i < half; ++i)
    add(GaussRule::abscissa()[i], GaussRule::weights()[i]);
}

bool may_push(const SmoothInterval &interval, const contact::ContactSet &contacts) {
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.pairs()[c].law->modes()[static_cast<std::size_t>(interval.modes[c])].in_contact)
      return true;
  return false;
}

std::vector<IntegrationNode> integration_nodes(const std::vector<SmoothInterval> &intervals,
                                               const contact::ContactSet &contacts) {
  std::vector<IntegrationNode> nodes;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const SmoothInterval &interval = intervals[i];
    if (!may_push(interval, contacts))
      continue;
    const long panels = (interval.steps + steps_in_panel - 1) / steps_in_panel;
    const double length = (interval.end - interval.start) / static_cast<double>(panels);
    for (long k = 0; k < panels; ++k)
      add_panel(nodes, i, interval, interval.start + static_cast<double>(k) * length, length);
  }
  return nodes;
}

} // namespace

ImpactTangents::ImpactTangents(const contact::ContactSet &contacts,
                               const std::vector<SmoothInterval> &intervals, FormTangents &forms)
    : impacts(contacts.size()), approach_speeds(contacts.size()), contacts_(contacts),
      intervals_(intervals), forms_(forms), nodes_(integration_nodes(intervals, contacts)),
      tracks_(contacts.size()) {
  if (!intervals.empty())
    start_ = intervals.front().start;
}

std::vector<double> ImpactTangents::stops() const {
  std::vector<double> stops;
  for (const IntegrationNode &node : nodes_)
    stops.push_back(node.time);
  return stops;
}

bool ImpactTangents::in_contact(std::size_t contact, int mode) const {
  return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(mode)].in_contact;
}

// A break of the sources ends an interval without moving.
void ImpactTangents::stop(std::size_t place, const TangentPoint &at) {
  const IntegrationNode &node = nodes_[place];
  const SmoothInterval &interval = intervals_[node.interval];
  if (interval.from_break && node.interval != interval_)
    close_interval(interval.start, 0);
  interval_ = node.interval;
  for (std::size_t c = 0; c < tracks_.size(); ++c) {
    Track &track = tracks_[c];
    if (!track.complete || !in_contact(c, at.equations().modes()[c]))
      continue;
    const Tangent force = forms_.force(c, at);
    track.change += node.weight * force.change;
    track.to_start += node.weight * force.rate * (1 - node.place);
    track.to_end += node.weight * force.rate * node.place;
    track.force += node.weight * force.value;
  }
}

void ImpactTangents::close_interval(double time, double delay) {
  if (time > start_) {
    const double stretch = (delay - start_delay_) / (time - start_);
    for (Track &track : tracks_) {
      if (track.change != 0 || track.force != 0)
        track.present.impulse += track.change + track.to_start * start_delay_ +
                                 track.to_end * delay + track.force * stretch;
      track.change = track.to_start = track.to_end = track.force = 0;
    }
  }
  start_ = time;
  start_delay_ = delay;
}

// Velocities before and after a collision change with the key, at its own instant.
void ImpactTangents::take_jumps(const TangentEvent &event) {
  const motion::Collision *collision = event.event.collision;
  if (!collision || collision->contacts.empty())
    return;
  const motion::StateLayout &layout = event.before.equations().layout();
  const auto velocities = [&](const Vector &of) -> Vector {
    return of.segment(layout.velocity(), layout.n);
  };
  const Vector jump = velocities(event.after.values() - event.before.values());
  const Vector change = velocities(event.after.change() - event.before.change() +
                                   event.delay * (event.after.rates() - event.before.rates()));
  const Vector impulses = forms_.impulses(*collision, jump, change);
  for (Index k = 0; k < impulses.size(); ++k) {
    Track &track = tracks_[collision->contacts[static_cast<std::size_t>(k)]];
    (track.complete ? track.present.impulse : track.jump) += impulses[k];
  }
}

void ImpactTangents::begin(Track &track, const TangentEvent &event) const {
  const double speed = forms_.gap_rate(event.event.contact, event.before).with(event.delay);
  track.present = {.approach_speed = -speed};
  if (event.event.guard->action == contact::GuardAction::impact)
    track.present.impulse = track.jump;
  track.jump = 0;
  track.begun = event.delay;
  track.complete = true;
}

void ImpactTangents::event(const TangentEvent &event) {
  const std::size_t c = event.event.contact;
  Track &track = tracks_[c];
  close_interval(event.event.time, event.delay);
  take_jumps(event);
  if (event.event.onset) {
    begin(track, event);
    approach_speeds[c].push_back(track.present.approach_speed);
  }
  const bool over = event.event.onset || in_contact(c, event.event.from);
  if (over && !in_contact(c, event.event.to) && track.complete) {
    track.present.duration = event.delay - track.begun;
    impacts[c].push_back(track.present);
    track.complete = false;
  }
}

} // namespace vibroimpact::analyses
