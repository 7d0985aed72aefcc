#include "model/time_function.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace vibroimpact::model {

namespace {

// s = A/w sin(wt + p - pi/2) has s' = A sin(wt + p); likewise twice for an acceleration.
int integrations(Given given) {
  return given == Given::displacement ? 0 : given == Given::velocity ? 1 : 2;
}

} // namespace

double TimeFunction::next_break(double /*time*/) const {
  return std::numeric_limits<double>::infinity();
}

std::optional<ExponentialForm> TimeFunction::exponential_form(double /*time*/) const {
  return std::nullopt;
}

Harmonic::Harmonic(Given given, double amplitude, double angular_frequency, double phase)
    : given_(given), amplitude_(amplitude), angular_frequency_(angular_frequency), phase_(phase),
      displacement_amplitude_(amplitude / std::pow(angular_frequency, integrations(given))),
      shift_(phase) {
  // Signs instead of shifts by pi/2 and pi keep s exactly zero where sin is.
  if (integrations(given) == 2)
    displacement_amplitude_ = -displacement_amplitude_;
  if (integrations(given) == 1)
    shift_ -= std::numbers::pi / 2;
}

double Harmonic::value(double time) const {
  return displacement_amplitude_ * std::sin(angular_frequency_ * time + shift_);
}

double Harmonic::rate(double time) const {
  return displacement_amplitude_ * angular_frequency_ *
         std::cos(angular_frequency_ * time + shift_);
}

double Harmonic::acceleration(double time) const {
  return -displacement_amplitude_ * angular_frequency_ * angular_frequency_ *
         std::sin(angular_frequency_ * time + shift_);
}

double Harmonic::period() const { return 2 * std::numbers::pi / angular_frequency_; }

std::shared_ptr<const TimeFunction> Harmonic::with_frequency(double angular_frequency) const {
  return std::make_shared<Harmonic>(given_, amplitude_, angular_frequency, phase_);
}

std::optional<ExponentialForm> Harmonic::exponential_form(double time) const {
  // A sin(x) = Re(-i A exp(i x))
  const double angle = angular_frequency_ * time + shift_;
  const std::complex<double> at_time = displacement_amplitude_ * std::polar(1.0, angle);
  return ExponentialForm{.origin = time,
                         .terms = {{.amplitude = {at_time.imag(), -at_time.real()},
                                    .exponent = {0, angular_frequency_}}},
                         .polynomial = {}};
}

} // namespace vibroimpact::model
