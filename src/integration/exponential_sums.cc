#include "integration/exponential_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact {

namespace {
constexpr int trials = 3;
constexpr double hermite_error = 1.0 / 384;
constexpr double flight_rounding = 256 * std::numeric_limits<double>::epsilon();
// Half of what is promised: the other half is for the error of the value it is compared with.
constexpr double value_rounding = 32 * std::numeric_limits<double>::epsilon();

std::complex<double> exponential(std::complex<double> exponent, double time) {
  const double size = std::exp(exponent.real() * time);
  return exponent.imag() == 0 ? std::complex<double>(size)
                              : std::polar(size, exponent.imag() * time);
}
} // namespace

void ExponentialSums::set(const Eigen::MatrixXcd &coefficients, const Matrix &sizes,
                          const Vector &constants, std::vector<Complex> exponents) {
  coefficients_ = coefficients.transpose();
  rounded_sizes_ = sizes.transpose();
  magnitudes_ = coefficients_.array().abs();
  constants_ = constants;
  exponents_ = std::move(exponents);
  const auto count = static_cast<Index>(exponents_.size());
  fourth_.resize(count);
  sixth_.resize(count);
  fastest_growth_ = 0;
  for (Index j = 0; j < count; ++j) {
    const Complex exponent = exponents_[static_cast<std::size_t>(j)];
    fourth_[j] = std::norm(exponent) * std::norm(exponent);
    sixth_[j] = fourth_[j] * std::norm(exponent);
    fastest_growth_ = std::max(fastest_growth_, exponent.real());
  }
  starts_.resize(static_cast<std::size_t>(size()));
  factors_.resize(exponents_.size());
  terms_.resize(count, size());
  sizes_.resize(count, size());
  amplitude_sizes_.resize(count);
  totals_.resize(size());
  bounds_.resize(size());
}

void ExponentialSums::start(std::span<const Complex> amplitudes) {
  for (Index j = 0; j < terms_.rows(); ++j)
    amplitude_sizes_[j] = std::sqrt(std::norm(amplitudes[static_cast<std::size_t>(j)]));
  for (Index g = 0; g < size(); ++g) {
    double total = std::abs(constants_[g]);
    for (Index j = 0; j < terms_.rows(); ++j) {
      terms_(j, g) = coefficients_(j, g) * amplitudes[static_cast<std::size_t>(j)];
      sizes_(j, g) = magnitudes_(j, g) * amplitude_sizes_[j];
      total += rounded_sizes_(j, g) * amplitude_sizes_[j];
    }
    totals_[g] = total;
  }
}

double ExponentialSums::positive_until(double limit) {
  if (size() == 0)
    return limit;
  double h = first_trial(limit);
  for (int i = 0; i < trials && h > 0; ++i, h *= 0.5)
    if (positive(h))
      return h;
  return 0;
}

// Where value and error bound would be equal, and where the cubic could fall to zero.
double ExponentialSums::first_trial(double limit) {
  double h = limit;
  for (Index g = 0; g < size(); ++g) {
    End &end = starts_[static_cast<std::size_t>(g)];
    end = {.value = constants_[g]};
    bounds_[g] = 0;
    for (Index j = 0; j < terms_.rows(); ++j) {
      end.value += terms_(j, g).real();
      end.slope += (terms_(j, g) * exponents_[static_cast<std::size_t>(j)]).real();
      bounds_[g] += sizes_(j, g) * fourth_[j];
    }
    if (end.value <= flight_rounding * totals_[g])
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
  for (std::size_t j = 0; j < factors_.size(); ++j)
    factors_[j] = exponential(exponents_[j], h);
  const double growth = fastest_growth_ > 0 ? std::exp(fastest_growth_ * h) : 1;
  for (Index g = 0; g < size(); ++g) {
    const End &start = starts_[static_cast<std::size_t>(g)];
    End end{.value = constants_[g]};
    for (Index j = 0; j < terms_.rows(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const Complex term = terms_(j, g) * factors_[k];
      end.value += term.real();
      end.slope += (term * exponents_[k]).real();
    }
    const double lowest = std::min(
        {start.value, start.value + h / 3 * start.slope, end.value - h / 3 * end.slope, end.value});
    const double error = hermite_error * h * h * h * h * growth * bounds_[g];
    if (lowest <= error + growth * flight_rounding * totals_[g])
      return false;
  }
  return true;
}

void ExponentialSums::end_at(double end, std::span<const Complex> factors) {
  end_ = end;
  end_factors_ = factors;
  end_growth_ = fastest_growth_ > 0 ? std::exp(fastest_growth_ * end) : 1;
}

Jet ExponentialSums::at(Index guard, double time) const {
  Jet jet{.value = constants_[guard]};
  for (Index j = 0; j < terms_.rows(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    Complex term = terms_(j, guard);
    if (time == end_)
      term *= end_factors_[k];
    else if (time != 0)
      term *= exponential(exponents_[k], time);
    jet.value += term.real();
    term *= exponents_[k];
    jet.rate += term.real();
    term *= exponents_[k];
    jet.acceleration += term.real();
  }
  return jet;
}

double ExponentialSums::sixth_derivative(Index guard, double from, double to) const {
  double bound = 0;
  for (Index j = 0; j < terms_.rows(); ++j) {
    const double growth = exponents_[static_cast<std::size_t>(j)].real();
    const double where = growth > 0 ? to : from;
    const double size = growth != 0 && where != 0 ? std::exp(growth * where) : 1;
    bound += size * sizes_(j, guard) * sixth_[j];
  }
  return bound;
}

double ExponentialSums::rounding(Index guard) const {
  return value_rounding * end_growth_ * totals_[guard];
}

} // namespace vibroimpact
