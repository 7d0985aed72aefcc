#include "analyses/derivatives/tangent_point.h"

#include "motion/variation/key_stencil.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vibroimpact::analyses {

namespace {

// Of the shortest time in which something happens: differences are then exact to about 1e-12.
constexpr double step_of_differences = 1e-3;

ConstVectorView state_view(const Vector &vector) { return {vector.data(), vector.size()}; }

/// df/dt of a function of the time that has passed, by five points.
template <class Function> Vector derivative(const Function &function, double step) {
  static const std::array<double, 4> places{-2, -1, 1, 2};
  static const Vector weights = motion::derivative_weights({places.begin(), places.end()});
  const Vector present = function(0);
  Vector sum = Vector::Zero(present.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    sum += weights[static_cast<Index>(i)] / step * (function(places[i] * step) - present);
  return sum;
}

} // namespace

TangentPoint::TangentPoint(const motion::Equations &equations, const motion::KeyTangent &key,
                           double time, const Vector &state, Vector change)
    : equations_(equations), key_(key), time_(time), state_(state), values_(values_at(time, state)),
      change_(Vector::Zero(values_.size())), rates_(rates_at(time, state)) {
  const Index physical = equations.layout().physical_size();
  change_.head(physical) = change;
  for (Index k = 0; k < (values_.size() - physical) / 3; ++k) {
    const std::array<double, 3> moved = key.sources().at(static_cast<std::size_t>(k), time);
    change_.segment(physical + 3 * k, 3) << moved[0], moved[1], moved[2];
  }
  const Vector third =
      derivative([&](double h) { return values_at(time + h, state); }, time_step());
  for (Index k = physical + 2; k < rates_.size(); k += 3)
    rates_[k] = third[k];
}

// Of the model or of an excitation, whichever changes faster.
double TangentPoint::time_step() const {
  double shortest = 1 / equations_.model().highest_frequency();
  for (const model::Source &source : equations_.model().sources())
    if (const double period = source.function->period(); period > 0)
      shortest = std::min(shortest, 0.1 * period);
  return step_of_differences * shortest;
}

Vector TangentPoint::values_at(double time, const Vector &state) const {
  std::vector<motion::SourceValues> sources;
  equations_.source_values(time, sources);
  const Index physical = equations_.layout().physical_size();
  Vector values(physical + 3 * static_cast<Index>(sources.size()));
  values.head(physical) = state.head(physical);
  for (std::size_t k = 0; k < sources.size(); ++k)
    values.segment(physical + 3 * static_cast<Index>(k), 3) << sources[k][0], sources[k][1],
        sources[k][2];
  return values;
}

// s''' is left out.
Vector TangentPoint::rates_at(double time, const Vector &state) const {
  Vector full(state.size());
  equations_.rates(time, state_view(state), VectorView(full.data(), full.size()));
  Vector rates = values_at(time, full);
  for (Index k = equations_.layout().physical_size(); k < rates.size(); k += 3) {
    rates[k] = rates[k + 1];
    rates[k + 1] = rates[k + 2];
    rates[k + 2] = 0;
  }
  return rates;
}

const Vector &TangentPoint::second_rates() const {
  if (!second_rates_)
    second_rates_ = derivative(
        [&](double h) {
          Vector moved = state_;
          const Index physical = equations_.layout().physical_size();
          moved.head(physical) += h * rates_.head(physical);
          return rates_at(time_ + h, moved);
        },
        time_step());
  return *second_rates_;
}

const Vector &TangentPoint::change_of_rates() const {
  if (change_of_rates_)
    return *change_of_rates_;
  const Index physical = equations_.layout().physical_size();
  Matrix jacobian;
  equations_.jacobian(time_, state_view(state_), jacobian);
  Vector change = Vector::Zero(values_.size());
  change.head(physical) = jacobian.topLeftCorner(physical, physical) * change_.head(physical) +
                          key_.rates(equations_, time_, state_);
  for (Index k = physical; k < change.size(); k += 3) {
    change[k] = change_[k + 1];
    change[k + 1] = change_[k + 2];
  }
  change_of_rates_ = std::move(change);
  return *change_of_rates_;
}

} // namespace vibroimpact::analyses
