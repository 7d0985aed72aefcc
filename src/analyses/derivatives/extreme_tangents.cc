#include "analyses/derivatives/extreme_tangents.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::analyses {

using motion::Extremum;

namespace {

// The largest difference between what the dense output of a step and the equations give, relative
// to the range of the quantity.
constexpr double resolved = 1e-3;

TangentOf reversed(TangentOf of) {
  return [of = std::move(of)](const TangentPoint &at) {
    const Tangent tangent = of(at);
    return Tangent{-tangent.value, -tangent.change, -tangent.rate};
  };
}

} // namespace

// Most steps end where nothing happens.
ExtremeTangents::ExtremeTangents(const std::vector<ObservedExtremum> &extrema,
                                 const std::vector<double> &events, FormTangents &forms) {
  for (const auto &[extremum, observed, bound] : extrema) {
    TangentOf of = forms.of(observed);
    places_.push_back({.extremum = extremum,
                       .of = bound == Bound::largest ? std::move(of) : reversed(std::move(of)),
                       .inside = extremum->side == Extremum::Side::inside ||
                                 !std::binary_search(events.begin(), events.end(), extremum->time),
                       .derivative = extremum->seen() ? nan : 0});
  }
  for (Place &place : places_)
    if (place.extremum->seen() && place.inside) {
      stops_.push_back({.time = place.extremum->time, .place = &place});
      stops_.push_back({.time = place.extremum->beside, .place = &place, .beside = true});
    }
  std::stable_sort(stops_.begin(), stops_.end(),
                   [](const Stop &one, const Stop &other) { return one.time < other.time; });
}

std::vector<double> ExtremeTangents::stops() const {
  std::vector<double> stops;
  for (const Stop &stop : stops_)
    stops.push_back(stop.time);
  return stops;
}

void ExtremeTangents::Place::take_inside() {
  const double shift = -(beside.change - at.change) / (beside.rate - at.rate);
  derivative = std::isfinite(shift) ? at.with(shift) : at.change;
}

void ExtremeTangents::stop(std::size_t place, const TangentPoint &at) {
  Place &here = *stops_[place].place;
  (stops_[place].beside ? here.beside : here.at) = here.of(at);
  here.take_inside();
}

// Of several events at one instant the first one has the value before, the last one that after.
void ExtremeTangents::event(const TangentEvent &event) {
  ++events_;
  const double near = 64 * std::numeric_limits<double>::epsilon() * std::abs(event.event.time);
  for (Place &place : places_) {
    const Extremum &extremum = *place.extremum;
    if (place.inside || std::abs(extremum.time - event.event.time) > near)
      continue;
    const bool after = extremum.side == Extremum::Side::start;
    if (!after && std::isfinite(place.derivative))
      continue;
    place.at = place.of(after ? event.after : event.before);
    place.derivative = place.at.with(event.delay);
  }
}

const ExtremeTangents::Place &ExtremeTangents::find(const Extremum &extremum) const {
  return *std::find_if(places_.begin(), places_.end(),
                       [&](const Place &place) { return place.extremum == &extremum; });
}

bool ExtremeTangents::is_of_motion(const Extremum &extremum, double range) const {
  const Place &place = find(extremum);
  return !extremum.seen() || !std::isfinite(place.derivative) ||
         std::abs(place.at.value - extremum.value) <= resolved * range;
}

} // namespace vibroimpact::analyses
