#include "integration/guard_sums.h"

#include <algorithm>

namespace vibroimpact {

void GuardSums::add_exponent(std::complex<double> exponent) {
  if (exponent.real() != 0)
    decaying.push_back(rate.size());
  if (exponent.imag() != 0)
    oscillating.push_back(rate.size());
  rate.push_back(exponent.real());
  frequency.push_back(exponent.imag());
  fastest = std::max(fastest, std::abs(exponent));
}

void GuardSums::add_guard(double constant_term, std::span<const std::complex<double>> coefficients,
                          std::span<const double> sizes) {
  constant.push_back(constant_term);
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    const double square = rate[j] * rate[j] + frequency[j] * frequency[j];
    real.push_back(coefficients[j].real());
    imaginary.push_back(coefficients[j].imag());
    size.push_back(sizes[j]);
    fourth.push_back(std::abs(coefficients[j]) * square * square);
  }
}

} // namespace vibroimpact
