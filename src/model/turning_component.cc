#include "model/turning_component.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::model {

double TurningComponent::value(double time) const { return std::cos(angle(time)); }

double TurningComponent::rate(double time) const {
  return -speed_.at(time) * std::sin(angle(time));
}

double TurningComponent::acceleration(double time) const {
  const double speed = speed_.at(time);
  return -speed * speed * std::cos(angle(time)) - speed_.rate(time) * std::sin(angle(time));
}

double TurningComponent::period() const {
  const double speed = std::abs(speed_.at(0));
  return speed_.constant() && speed > 0 ? 2 * std::numbers::pi / speed : 0;
}

std::optional<ExponentialForm> TurningComponent::exponential_form(double time) const {
  if (speed_.rate(time) != 0)
    return std::nullopt;
  if (speed_.at(time) == 0)
    return ExponentialForm{.origin = time, .terms = {}, .polynomial = {value(time)}};
  return ExponentialForm{
      .origin = time,
      .terms = {{.amplitude = std::polar(1.0, angle(time)), .exponent = {0, speed_.at(time)}}},
      .polynomial = {}};
}

} // namespace vibroimpact::model
