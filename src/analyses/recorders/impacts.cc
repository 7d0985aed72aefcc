#include "analyses/recorders/impacts.h"

#include "analyses/derivatives/tangent_motion.h"
#include "analyses/recorders/observables.h"
#include "analyses/results/fields.h"
#include "common/scalar.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vibroimpact::analyses {

using motion::Impact;

namespace {

void add_range(const FieldWriter &result, const RangeLabels &labels,
               const std::vector<double> &values) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(values.size(), 1));
  const bool none = values.empty();
  result.number(labels.mean, none ? nan : mean);
  result.number(labels.minimum, none ? nan : *lowest);
  result.number(labels.maximum, none ? nan : *highest);
}

// The mean has the mean of the derivatives, the largest value its own; what has no closed form is
// left out.
void add_range_tangents(const FieldWriter &result, const RangeLabels &labels,
                        const std::vector<double> &values, const std::vector<double> &derivatives) {
  if (values.empty() || values.size() != derivatives.size())
    return;
  const auto add = [&](const Label &label, double derivative) {
    if (std::isfinite(derivative))
      result.number(label, derivative);
  };
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  add(labels.minimum, derivatives[static_cast<std::size_t>(lowest - values.begin())]);
  add(labels.maximum, derivatives[static_cast<std::size_t>(highest - values.begin())]);
  add(labels.mean, std::accumulate(derivatives.begin(), derivatives.end(), 0.0) /
                       static_cast<double>(values.size()));
}

enum class Lasting : bool { left_out, included };

std::vector<double> values_of(const std::vector<Impact> &impacts, double Impact::*member,
                              Lasting lasting) {
  std::vector<double> values;
  for (const Impact &impact : impacts)
    if (impact.finished || lasting == Lasting::included)
      values.push_back(impact.*member);
  return values;
}

} // namespace

RangeLabels::RangeLabels(const std::string &path, const std::string &unit,
                         const std::string &meaning)
    : mean(path + "/mean", unit, meaning + ", mean of the impacts"),
      minimum(path + "/minimum", unit, meaning + ", smallest"),
      maximum(path + "/maximum", unit, meaning + ", largest") {}

Impacts::Labels::Labels(const std::string &contact)
    : impacts("contact/" + contact + "/impacts", "1", "impacts begun in the recorded window"),
      unfinished("contact/" + contact + "/unfinished", "1",
                 "of these, impacts that last at the end of the window: 0 or 1"),
      impacts_per_period("contact/" + contact + "/impacts_per_period", "1",
                         "impacts begun per forcing period"),
      contact_fraction("contact/" + contact + "/contact_fraction", "1",
                       "contact fraction: part of the recorded window in contact"),
      chatters("contact/" + contact + "/chatters", "1",
               "infinite sequences of rigid impacts that were completed in the recorded window"),
      approach_speed("contact/" + contact + "/approach_speed", "m/s",
                     "closing speed just before contact"),
      impulse("contact/" + contact + "/impulse", "N s", "time integral of the normal force"),
      peak_force("contact/" + contact + "/peak_force", "N", "largest normal force"),
      contact_duration("contact/" + contact + "/contact_duration", "s", "time in contact"),
      penetration("contact/" + contact + "/penetration", "m", "largest overlap") {}

Impacts::Impacts(const System &system)
    : contacts_(system.contacts), log_(system.contacts, 0),
      time_in_contact_(system.contacts.size(), 0), chatters_(system.contacts.size(), 0),
      approach_speeds_(system.contacts.size()) {
  for (const contact::ContactPair &pair : contacts_.pairs())
    labels_.emplace_back(pair.name);
}

void Impacts::declare(parameters::Section & /*analysis*/) {}

RecorderFactory Impacts::create(const parameters::Values & /*analysis*/) {
  return [](const System &system) { return std::make_unique<Impacts>(system); };
}

void Impacts::begin(const Window &window, const motion::Trajectory & /*trajectory*/) {
  window_ = window;
  log_.start_afresh();
  std::fill(time_in_contact_.begin(), time_in_contact_.end(), 0);
  std::fill(chatters_.begin(), chatters_.end(), 0);
  for (std::vector<double> &speeds : approach_speeds_)
    speeds.clear();
}

void Impacts::step(const motion::StepView &view) {
  log_.step(view);
  note_contacts(view);
}

void Impacts::interval(const motion::Interval &interval) {
  log_.interval(interval);
  note_contacts(interval);
}

void Impacts::note_contacts(const motion::Interval &interval) {
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (interval.equations().mode(c).in_contact)
      time_in_contact_[c] += interval.length();
}

void Impacts::event(const motion::ContactEvent &event) {
  log_.event(event);
  if (event.onset)
    approach_speeds_[event.contact].push_back(-event.gap_rate);
  if (event.chatter_duration > 0)
    ++chatters_[event.contact];
}

void Impacts::end(const motion::Trajectory &trajectory) {
  log_.end_record(trajectory.time(), trajectory.state(), trajectory.layout());
}

void Impacts::add_fields(const FieldWriter &result) const {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const Labels &labels = labels_[c];
    const auto begun = static_cast<double>(log_.begun(c));
    const std::vector<Impact> &impacts = log_.impacts(c);
    const bool lasts = !impacts.empty() && !impacts.back().finished;
    result.number(labels.impacts, begun);
    result.number(labels.unfinished, lasts ? 1 : 0);
    if (window_.cycles > 0)
      result.number(labels.impacts_per_period, begun / static_cast<double>(window_.cycles));
    result.number(labels.contact_fraction, time_in_contact_[c] / window_.length());
    result.number(labels.chatters, static_cast<double>(chatters_[c]));
    add_range(result, labels.approach_speed, approach_speeds_[c]);
    add_range(result, labels.impulse, values_of(impacts, &Impact::impulse, Lasting::left_out));
    add_range(result, labels.peak_force,
              values_of(impacts, &Impact::peak_force, Lasting::included));
    add_range(result, labels.contact_duration,
              values_of(impacts, &Impact::duration, Lasting::left_out));
    add_range(result, labels.penetration,
              values_of(impacts, &Impact::maximum_penetration, Lasting::included));
  }
}

bool Impacts::keeps_extrema() {
  log_.keep_extrema();
  return true;
}

std::vector<ObservedExtremum> Impacts::extrema() const {
  std::vector<ObservedExtremum> list;
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    for (const Impact &impact : log_.impacts(c)) {
      list.push_back({&impact.force, normal_force(contacts_, c), Bound::largest});
      list.push_back({&impact.overlap, gap_of(contacts_, c), Bound::smallest});
    }
  return list;
}

void Impacts::add_tangents(const TangentMotion &motion, const FieldWriter &result) const {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const std::vector<Impact> &impacts = log_.impacts(c);
    const auto of_extrema = [&](motion::Extremum Impact::*member) {
      std::vector<double> derivatives;
      for (const Impact &impact : impacts)
        derivatives.push_back(motion.extremes.of(impact.*member));
      return derivatives;
    };
    const auto of_ended = [&](const RangeLabels &labels, double Impact::*member,
                              double ImpactTangent::*derivative) {
      std::vector<double> derivatives;
      for (const ImpactTangent &impact : motion.impacts.impacts[c])
        derivatives.push_back(impact.*derivative);
      add_range_tangents(result, labels, values_of(impacts, member, Lasting::left_out),
                         derivatives);
    };
    const auto of_all = [&](double Impact::*member) {
      return values_of(impacts, member, Lasting::included);
    };
    add_range_tangents(result, labels_[c].peak_force, of_all(&Impact::peak_force),
                       of_extrema(&Impact::force));
    add_range_tangents(result, labels_[c].penetration, of_all(&Impact::maximum_penetration),
                       of_extrema(&Impact::overlap));
    add_range_tangents(result, labels_[c].approach_speed, approach_speeds_[c],
                       motion.impacts.approach_speeds[c]);
    of_ended(labels_[c].impulse, &Impact::impulse, &ImpactTangent::impulse);
    of_ended(labels_[c].contact_duration, &Impact::duration, &ImpactTangent::duration);
  }
}

} // namespace vibroimpact::analyses
