#include "integration/exponential_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact {

namespace {
constexpr int trials = 3;
constexpr double hermite_error = 1.0 / 384;
constexpr double rounding = 256 * std::numeric_limits<double>::epsilon();
} // namespace

void ExponentialSums::set(const Eigen::MatrixXcd &coefficients, const Vector &constants,
                          std::vector<Complex> exponents) {
  coefficients_ = coefficients;
  constants_ = constants;
  exponents_ = std::move(exponents);
  fourth_.clear();
  for (const Complex exponent : exponents_)
    fourth_.push_back(std::norm(exponent) * std::norm(exponent));
  starts_.resize(static_cast<std::size_t>(size()));
  factors_.resize(exponents_.size());
  terms_.resize(size(), static_cast<Index>(exponents_.size()));
  sizes_.resize(terms_.rows(), terms_.cols());
  bounds_.resize(size());
  margins_.resize(size());
}

double ExponentialSums::positive_until(double limit, std::span<const Complex> amplitudes) {
  if (size() == 0)
    return limit;
  start(amplitudes);
  double h = first_trial(limit);
  for (int i = 0; i < trials && h > 0; ++i, h *= 0.5)
    if (positive(h))
      return h;
  return 0;
}

void ExponentialSums::start(std::span<const Complex> amplitudes) {
  for (Index g = 0; g < size(); ++g) {
    End &end = starts_[static_cast<std::size_t>(g)];
    end = {.value = constants_[g]};
    bounds_[g] = 0;
    double size = std::abs(constants_[g]);
    for (Index j = 0; j < terms_.cols(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const Complex term = coefficients_(g, j) * amplitudes[k];
      terms_(g, j) = term;
      sizes_(g, j) = std::sqrt(std::norm(term));
      end.value += term.real();
      end.slope += (term * exponents_[k]).real();
      size += sizes_(g, j);
      bounds_[g] += sizes_(g, j) * fourth_[k];
    }
    margins_[g] = rounding * size;
  }
}

// Where value and error bound would be equal, and where the cubic could fall to zero.
double ExponentialSums::first_trial(double limit) const {
  double h = limit;
  for (Index g = 0; g < size(); ++g) {
    const End &end = starts_[static_cast<std::size_t>(g)];
    if (end.value <= margins_[g])
      return 0;
    const double allowed = end.value / (hermite_error * bounds_[g]);
    if (bounds_[g] > 0)
      h = std::min(h, std::sqrt(std::sqrt(allowed)));
    if (end.slope < 0)
      h = std::min(h, -2.5 * end.value / end.slope);
  }
  return h;
}

bool ExponentialSums::positive(double h) {
  double growth = 1;
  for (std::size_t j = 0; j < factors_.size(); ++j) {
    const Complex e = exponents_[j];
    const double size = std::exp(e.real() * h);
    growth = std::max(growth, size);
    factors_[j] = e.imag() == 0 ? Complex(size) : std::polar(size, e.imag() * h);
  }
  for (Index g = 0; g < size(); ++g) {
    const End &start = starts_[static_cast<std::size_t>(g)];
    End end{.value = constants_[g]};
    for (Index j = 0; j < terms_.cols(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const Complex term = terms_(g, j) * factors_[k];
      end.value += term.real();
      end.slope += (term * exponents_[k]).real();
    }
    const double lowest = std::min(
        {start.value, start.value + h / 3 * start.slope, end.value - h / 3 * end.slope, end.value});
    const double error = hermite_error * h * h * h * h * growth * bounds_[g];
    if (lowest <= error + growth * margins_[g])
      return false;
  }
  return true;
}

} // namespace vibroimpact
