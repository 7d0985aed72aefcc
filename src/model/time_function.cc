#include "model/time_function.h"

#include <cmath>
#include <numbers>

namespace vibroimpact {

namespace {

// s = A/w sin(wt + p - pi/2) has s' = A sin(wt + p); likewise twice for an acceleration.
int integrations(Given given) {
  return given == Given::displacement ? 0 : given == Given::velocity ? 1 : 2;
}

} // namespace

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

} // namespace vibroimpact
