#include "model/exponential_form.h"

#include <cmath>

namespace vibroimpact::model {

namespace {

// exp(exponent t), without what a general complex exponential does for nothing.
std::complex<double> growth(const std::complex<double> &exponent, double t) {
  const double size = exponent.real() == 0 ? 1 : std::exp(exponent.real() * t);
  return exponent.imag() == 0 ? size : std::polar(size, exponent.imag() * t);
}

} // namespace

double ExponentialForm::value(double time) const {
  const double t = time - origin;
  double sum = 0;
  for (std::size_t j = polynomial.size(); j-- > 0;)
    sum = sum * t + polynomial[j];
  for (const Term &term : terms)
    sum += std::real(term.amplitude * growth(term.exponent, t));
  return sum;
}

double ExponentialForm::rate(double time) const {
  const double t = time - origin;
  double sum = 0;
  for (std::size_t j = polynomial.size(); j-- > 1;)
    sum = sum * t + static_cast<double>(j) * polynomial[j];
  for (const Term &term : terms)
    sum += std::real(term.amplitude * term.exponent * growth(term.exponent, t));
  return sum;
}

double ExponentialForm::acceleration(double time) const {
  const double t = time - origin;
  double sum = 0;
  for (std::size_t j = polynomial.size(); j-- > 2;)
    sum = sum * t + static_cast<double>(j * (j - 1)) * polynomial[j];
  for (const Term &term : terms)
    sum += std::real(term.amplitude * term.exponent * term.exponent * growth(term.exponent, t));
  return sum;
}

ExponentialForm ExponentialForm::about(double new_origin) const {
  const double shift = new_origin - origin;
  ExponentialForm form = *this;
  form.origin = new_origin;
  for (Term &term : form.terms)
    term.amplitude *= growth(term.exponent, shift);
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

} // namespace vibroimpact::model
