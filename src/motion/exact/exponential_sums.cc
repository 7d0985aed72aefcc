#include "motion/exact/exponential_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {
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
  sixth_.resize(count);
  fastest_growth_ = 0;
  for (Index j = 0; j < count; ++j) {
    const Complex exponent = exponents_[static_cast<std::size_t>(j)];
    sixth_[j] = std::norm(exponent) * std::norm(exponent) * std::norm(exponent);
    fastest_growth_ = std::max(fastest_growth_, exponent.real());
  }
  terms_.resize(count, size());
  sizes_.resize(count, size());
  amplitude_sizes_.resize(count);
  totals_.resize(size());
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

} // namespace vibroimpact::motion
