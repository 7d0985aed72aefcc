#include "analyses/derivatives/measure_tangents.h"

#include "analyses/derivatives/impact_tangents.h"
#include "analyses/recorders/extreme_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vibroimpact::analyses {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Measures = std::map<std::string, double>;
using ValueOf = std::function<Tangent(const TangentPoint &)>;

/// What is to be evaluated where the motion passes. Inside a smooth interval the instant t* itself
/// is known only up to the dense output of a step, m' is not quite zero there, and dm/dp at a fixed
/// time changes fast where the whole motion shifts in time. To first order in both
///
///   d max/dp = dm/dp + m' dt*/dp,   dt*/dp = -(d/dt dm/dp) / m''
///
/// with the two slopes from an instant close by.
struct Request {
  Extreme extreme;
  ValueOf of;
  double derivative = none;
  Tangent at{}, beside{};

  void take_inside() {
    const double shift = -(beside.change - at.change) / (beside.rate - at.rate);
    derivative = std::isfinite(shift) ? at.with(shift) : at.change;
  }
};

// The largest difference between what the dense output of a step and the equations give, relative
// to the range of the quantity.
constexpr double resolved = 1e-3;

class Requests {
public:
  /// The place of its derivative. Something that was never seen stays at its value.
  std::size_t add(const Extreme &extreme, ValueOf of) {
    list_.push_back({.extreme = extreme, .of = std::move(of)});
    if (!extreme.seen())
      list_.back().derivative = 0;
    return list_.size() - 1;
  }
  double operator[](std::size_t place) const { return list_[place].derivative; }
  /// The motion has the value that was seen, which has this sign.
  bool is_of_motion(std::size_t place, double sign, double range) const {
    const Request &request = list_[place];
    return !request.extreme.seen() || !std::isfinite(request.derivative) ||
           std::abs(sign * request.at.value - request.extreme.value) <= resolved * range;
  }
  std::vector<Request> &list() { return list_; }

private:
  std::vector<Request> list_;
};

/// Extreme values on the way.
class ExtremeEvaluation : public TangentVisitor {
public:
  explicit ExtremeEvaluation(Requests &requests);
  std::vector<double> stops() const;
  std::size_t events() const { return events_; }
  void stop(std::size_t place, const TangentPoint &at) override;
  void event(const TangentEvent &event) override;

private:
  /// Inside a smooth interval.
  struct Stop {
    double time = 0;
    Request *request = nullptr;
    bool beside = false;
  };
  std::vector<Stop> stops_; ///< in the order of time
  Requests &requests_;
  std::size_t events_ = 0;
};

ExtremeEvaluation::ExtremeEvaluation(Requests &requests) : requests_(requests) {
  for (Request &request : requests.list())
    if (request.extreme.seen() && request.extreme.place == Extreme::Place::inside) {
      stops_.push_back({.time = request.extreme.time, .request = &request});
      stops_.push_back({.time = request.extreme.beside, .request = &request, .beside = true});
    }
  std::stable_sort(stops_.begin(), stops_.end(),
                   [](const Stop &one, const Stop &other) { return one.time < other.time; });
}

std::vector<double> ExtremeEvaluation::stops() const {
  std::vector<double> stops;
  for (const Stop &stop : stops_)
    stops.push_back(stop.time);
  return stops;
}

void ExtremeEvaluation::stop(std::size_t place, const TangentPoint &at) {
  const Stop &stop = stops_[place];
  (stop.beside ? stop.request->beside : stop.request->at) = stop.request->of(at);
  stop.request->take_inside();
}

// Of several events at one instant the first one has the value before, the last one that after.
void ExtremeEvaluation::event(const TangentEvent &event) {
  ++events_;
  const double near = 64 * std::numeric_limits<double>::epsilon() * std::abs(event.event.time);
  for (Request &request : requests_.list()) {
    const Extreme &extreme = request.extreme;
    if (extreme.place == Extreme::Place::inside || std::abs(extreme.time - event.event.time) > near)
      continue;
    if (extreme.place == Extreme::Place::before_event && std::isfinite(request.derivative))
      continue;
    request.at =
        request.of(extreme.place == Extreme::Place::after_event ? event.after : event.before);
    request.derivative = request.at.with(event.delay);
  }
}

/// Impacts on the way. Apart from extreme values: stops close to where the slope of a force is
/// infinite cost digits of what follows.
class ImpactEvaluation : public TangentVisitor {
public:
  ImpactEvaluation(std::vector<IntegrationNode> nodes, ImpactTangents &impacts)
      : nodes_(std::move(nodes)), impacts_(impacts) {}
  std::vector<double> stops() const {
    std::vector<double> stops;
    for (const IntegrationNode &node : nodes_)
      stops.push_back(node.time);
    return stops;
  }
  void stop(std::size_t place, const TangentPoint &at) override {
    impacts_.node(nodes_[place], at);
  }
  void event(const TangentEvent &event) override { impacts_.event(event); }

private:
  std::vector<IntegrationNode> nodes_;
  ImpactTangents &impacts_;
};

/// Names of values and where their derivatives are found.
class Quantities {
public:
  Quantities(const ExtremeSearch &search, FormTangents &forms, Requests &requests);
  void add_measures(const Requests &requests, Measures &measures) const;

private:
  struct Places {
    std::size_t quantity = 0, largest = 0, smallest = 0;
  };
  const ExtremeSearch &search_;
  const std::vector<Observable> &quantities_;
  std::vector<Places> places_;
};

Quantities::Quantities(const ExtremeSearch &search, FormTangents &forms, Requests &requests)
    : search_(search), quantities_(forms.quantities()) {
  for (std::size_t i = 0; i < quantities_.size(); ++i) {
    if (!quantities_[i].is_linear())
      continue;
    const ValueOf of = [&forms, i](const TangentPoint &at) { return forms.quantity(i, at); };
    places_.push_back({.quantity = i,
                       .largest = requests.add(search.largest[i], of),
                       .smallest = requests.add(search.smallest[i], of)});
  }
}

/// What has no closed form is left out.
void put(const std::string &name, double derivative, Measures &measures) {
  if (std::isfinite(derivative))
    measures[name] = derivative;
}

void Quantities::add_measures(const Requests &requests, Measures &measures) const {
  for (const auto &[i, largest, smallest] : places_) {
    const double above = search_.largest[i].value, below = search_.smallest[i].value;
    const double range = std::max(above + below, std::max(std::abs(above), std::abs(below)));
    const bool sound =
        requests.is_of_motion(largest, 1, range) && requests.is_of_motion(smallest, -1, range);
    const double high = sound ? requests[largest] : none;
    const double low = sound ? requests[smallest] : none;
    const ExtremeValueLabels labels(quantities_[i]);
    const Measures all{{labels.maximum.name(), high},
                       {labels.minimum.name(), low},
                       {labels.peak_to_peak.name(), high - low},
                       {labels.amplitude.name(), (high - low) / 2},
                       {labels.largest.name(), above >= below ? high : 0 - low}};
    for (const auto &[name, derivative] : all)
      if (sound)
        put(name, derivative, measures);
      else
        measures[name] = none;
  }
}

/// Mean, smallest and largest of values with their derivatives.
void add_range(const std::string &path, const std::vector<double> &values,
               const std::vector<double> &derivatives, Measures &measures) {
  if (values.empty() || values.size() != derivatives.size())
    return;
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  put(path + "/minimum", derivatives[static_cast<std::size_t>(lowest - values.begin())], measures);
  put(path + "/maximum", derivatives[static_cast<std::size_t>(highest - values.begin())], measures);
  put(path + "/mean",
      std::accumulate(derivatives.begin(), derivatives.end(), 0.0) /
          static_cast<double>(values.size()),
      measures);
}

/// Of one contact.
class ContactMeasures {
public:
  ContactMeasures(std::size_t contact, const ExtremeSearch &search, FormTangents &forms,
                  Requests &requests);
  void add_measures(const std::string &path, const Requests &requests,
                    const ImpactTangents &tangents, Measures &measures) const;

private:
  void add_finished(const std::string &path, double motion::Impact::*value,
                    double ImpactTangent::*derivative, const ImpactTangents &tangents,
                    Measures &measures) const;
  std::size_t contact_;
  const ExtremeSearch &search_;
  std::size_t force_ = 0;                      ///< the largest one of the window
  std::vector<std::size_t> forces_, overlaps_; ///< of each impact
};

ContactMeasures::ContactMeasures(std::size_t contact, const ExtremeSearch &search,
                                 FormTangents &forms, Requests &requests)
    : contact_(contact), search_(search) {
  const ValueOf force = [&forms, contact](const TangentPoint &at) {
    return forms.force(contact, at);
  };
  const ValueOf overlap = [&forms, contact](const TangentPoint &at) {
    const Tangent gap = forms.gap(contact, at);
    return Tangent{-gap.value, -gap.change, -gap.rate};
  };
  force_ = requests.add(search.forces[contact], force);
  for (const ImpactExtremes &impact : search.impacts[contact]) {
    forces_.push_back(requests.add(impact.force, force));
    overlaps_.push_back(requests.add(impact.overlap, overlap));
  }
}

// Of impacts that last at the end of the window neither is known.
void ContactMeasures::add_finished(const std::string &path, double motion::Impact::*value,
                                   double ImpactTangent::*derivative,
                                   const ImpactTangents &tangents, Measures &measures) const {
  std::vector<double> values, derivatives;
  for (const motion::Impact &impact : search_.log.impacts(contact_))
    if (impact.finished)
      values.push_back(impact.*value);
  for (const ImpactTangent &impact : tangents.impacts[contact_])
    derivatives.push_back(impact.*derivative);
  add_range(path, values, derivatives, measures);
}

void ContactMeasures::add_measures(const std::string &path, const Requests &requests,
                                   const ImpactTangents &tangents, Measures &measures) const {
  std::vector<double> forces, overlaps, by_force, by_overlap;
  for (std::size_t i = 0; i < search_.log.impacts(contact_).size(); ++i) {
    forces.push_back(search_.log.impacts(contact_)[i].peak_force);
    overlaps.push_back(search_.log.impacts(contact_)[i].maximum_penetration);
    by_force.push_back(requests[forces_[i]]);
    by_overlap.push_back(requests[overlaps_[i]]);
  }
  put(path + "/normal_force/maximum", requests[force_], measures);
  add_range(path + "/peak_force", forces, by_force, measures);
  add_range(path + "/penetration", overlaps, by_overlap, measures);
  add_range(path + "/approach_speed", search_.approach_speeds[contact_],
            tangents.approach_speeds[contact_], measures);
  add_finished(path + "/impulse", &motion::Impact::impulse, &ImpactTangent::impulse, tangents,
               measures);
  add_finished(path + "/contact_duration", &motion::Impact::duration, &ImpactTangent::duration,
               tangents, measures);
}

/// The window: one period of the motion from its section.
struct Period {
  periodic::ForcedSystem forced;
  double start = 0, end = 0; ///< [s]
  motion::MotionState state;

  explicit Period(const RecordedOrbit &motion)
      : forced(motion.system.model, motion.system.contacts, motion.system.integration,
               motion.map.system().source()),
        start(motion.orbit.section.phase * forced.period()),
        end(start + static_cast<double>(motion.orbit.multiple()) * forced.period()),
        state{.time = start, .physical = motion.orbit.point.state} {}
};

} // namespace

std::map<std::string, double> measure_tangents(const RecordedOrbit &motion,
                                               periodic::ForcedKey &key,
                                               const std::vector<motion::KeyNeighbour> &neighbours,
                                               const Vector &by_key) {
  Period period(motion);
  motion::Trajectory &trajectory = period.forced.trajectory();
  FormTangents forms(motion.system, neighbours);
  ExtremeSearch search(motion.system, forms.quantities());
  trajectory.start(period.state);
  trajectory.advance(period.end, search);
  search.end(trajectory);
  if (search.breaks && key.tangent.sources().break_rate() != 0)
    return {};
  const contact::ContactSet &contacts = motion.system.contacts;
  Requests requests;
  const Quantities quantities(search, forms, requests);
  std::vector<ContactMeasures> of_contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    of_contacts.emplace_back(c, search, forms, requests);
  ImpactTangents impacts(contacts, search, forms);
  ExtremeEvaluation extremes(requests);
  ImpactEvaluation at_impacts(integration_nodes(search, contacts), impacts);
  const double phase = motion.orbit.section.phase;
  const Vector at_fixed_time =
      by_key - phase * key.period * motion.map.rates(phase, motion.orbit.point.state);
  const auto follow = [&](const std::vector<double> &stops, TangentVisitor &visitor) {
    follow_tangent(trajectory, {.state = period.state, .change = at_fixed_time}, stops, period.end,
                   key.tangent, orbit_accuracy(motion.system, period.forced), forms, visitor);
  };
  follow(extremes.stops(), extremes);
  follow(at_impacts.stops(), at_impacts);
  Measures measures;
  if (extremes.events() != search.events.size())
    return measures;
  quantities.add_measures(requests, measures);
  for (std::size_t c = 0; c < contacts.size(); ++c)
    of_contacts[c].add_measures("contact/" + contacts.pairs()[c].name, requests, impacts, measures);
  return measures;
}

} // namespace vibroimpact::analyses
