#include "model/time_function.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact {

namespace {

// s = A/w sin(wt + p - pi/2) has s' = A sin(wt + p); likewise twice for an acceleration.
int integrations(Given given) {
  return given == Given::displacement ? 0 : given == Given::velocity ? 1 : 2;
}

} // namespace

double ExponentialForm::value(double time) const {
  const double t = time - origin;
  double sum = 0;
  for (std::size_t j = polynomial.size(); j-- > 0;)
    sum = sum * t + polynomial[j];
  for (const Term &term : terms)
    sum += std::real(term.amplitude * std::exp(term.exponent * t));
  return sum;
}

double ExponentialForm::rate(double time) const {
  const double t = time - origin;
  double sum = 0;
  for (std::size_t j = polynomial.size(); j-- > 1;)
    sum = sum * t + static_cast<double>(j) * polynomial[j];
  for (const Term &term : terms)
    sum += std::real(term.amplitude * term.exponent * std::exp(term.exponent * t));
  return sum;
}

double ExponentialForm::acceleration(double time) const {
  const double t = time - origin;
  double sum = 0;
  for (std::size_t j = polynomial.size(); j-- > 2;)
    sum = sum * t + static_cast<double>(j * (j - 1)) * polynomial[j];
  for (const Term &term : terms)
    sum += std::real(term.amplitude * term.exponent * term.exponent * std::exp(term.exponent * t));
  return sum;
}

ExponentialForm ExponentialForm::about(double new_origin) const {
  const double shift = new_origin - origin;
  ExponentialForm form = *this;
  form.origin = new_origin;
  for (Term &term : form.terms)
    term.amplitude *= std::exp(term.exponent * shift);
  // Repeated synthetic division: the Taylor coefficients at the new origin.
  for (std::size_t j = 0; j + 1 < polynomial.size(); ++j)
    for (std::size_t i = polynomial.size() - 1; i-- > j;)
      form.polynomial[i] += shift * form.polynomial[i + 1];
  return form;
}

ExponentialForm ExponentialForm::integral(double constant) const {
  ExponentialForm form{.origin = origin, .terms = terms, .polynomial = {constant}};
  for (Term &term : form.terms) {
    term.amplitude /= term.exponent;
    form.polynomial[0] -= term.amplitude.real();
  }
  for (std::size_t j = 0; j < polynomial.size(); ++j)
    form.polynomial.push_back(polynomial[j] / static_cast<double>(j + 1));
  return form;
}

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

} // namespace vibroimpact
