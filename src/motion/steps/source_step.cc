#include "motion/steps/source_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vibroimpact::motion {

using model::ExponentialForm;

double third_derivative(const ExponentialForm &form, double time) {
  const double t = time - form.origin;
  double sum = 0;
  for (std::size_t j = form.polynomial.size(); j-- > 3;)
    sum = sum * t + static_cast<double>(j * (j - 1) * (j - 2)) * form.polynomial[j];
  for (const ExponentialForm::Term &term : form.terms)
    sum += std::real(term.amplitude * term.exponent * term.exponent * term.exponent *
                     std::exp(term.exponent * t));
  return sum;
}

// What the form's terms come to together, by value, rate and acceleration over a length [s]: where
// they cancel, as at the end of a versed sine, their rounding is that of each.
double size_of_terms(const ExponentialForm &form, double length) {
  double sum = 0;
  for (std::size_t j = form.polynomial.size(); j-- > 0;)
    sum = sum * length + std::abs(form.polynomial[j]);
  for (const ExponentialForm::Term &term : form.terms) {
    const double turn = length * std::abs(term.exponent);
    sum += std::abs(term.amplitude) * (1 + turn + turn * turn);
  }
  return sum;
}

SourceStep::SourceStep(const Equations &equations, double relative)
    : equations_(equations), relative_(relative) {
  for (std::size_t k = 0; k < equations.model().sources().size(); ++k) {
    const auto moved_by = [k](const contact::ContactPair &pair) {
      return !pair.tangential.empty() || pair.circle ||
             (k < pair.gap.base_coefficients.size() && pair.gap.base_coefficients[k] != 0);
    };
    const std::vector<contact::ContactPair> &pairs = equations.contacts().pairs();
    if (std::any_of(pairs.begin(), pairs.end(), moved_by))
      moving_.push_back(k);
  }
}

// Or rests on what sources move, beside a contact that slides as they do.
bool SourceStep::sticks() const {
  const ActiveConstraints &holding = equations_.holding();
  for (Index k = 0; k < holding.size(); ++k)
    if (holding.held(k).direction > 0 || equations_.layout().n_sliding > 0)
      return true;
  return false;
}

double SourceStep::error(double time, double length, const Vector &tolerances) const {
  double largest = 0;
  for (const std::size_t k : moving_) {
    const model::TimeFunction &function = *equations_.model().sources()[k].function;
    const auto at = [&](double t) { return equations_.source_time(t); };
    const double a = at(time);
    const double b = at(time + length);
    const double value[2] = {function.value(a), function.value(b)};
    const double rate[2] = {length * function.rate(a), length * function.rate(b)};
    const double bend[2] = {length * length * function.acceleration(a),
                            length * length * function.acceleration(b)};
    const double middle =
        (value[0] + value[1]) / 2 + 5 * (rate[0] - rate[1]) / 32 + (bend[0] + bend[1]) / 64;
    const double size = std::abs(value[0]) + std::abs(value[1]) + std::abs(rate[0]) +
                        std::abs(rate[1]) + std::abs(bend[0]) + std::abs(bend[1]);
    const double missed = std::abs(middle - function.value(at(time + length / 2)));
    double allowed = tolerances[static_cast<Index>(k)];
    if (sticks())
      allowed = std::min(allowed, relative_ * size);
    if (missed <= allowed)
      continue;
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    const std::optional<ExponentialForm> form = function.exponential_form(a);
    allowed += rounding * (form ? size_of_terms(*form, length) : size);
    largest = std::max(largest, missed / allowed);
  }
  return largest;
}

// The error goes with the sixth power of the length where a source is smooth. Stock methods see
// nothing of the work of a base that moves the gap of a body which a contact holds.
double SourceStep::limited(double time, double length, const Vector &tolerances) const {
  constexpr int most_trials = 30;
  if (moving_.empty())
    return length;
  for (int i = 0; i < most_trials; ++i) {
    const double too_large = error(time, length, tolerances);
    if (too_large <= 1)
      break;
    length *= std::isfinite(too_large) ? std::max(0.2, 0.9 * std::pow(too_large, -1.0 / 6)) : 0.2;
  }
  return length;
}

} // namespace vibroimpact::motion
