#include "integration/guard_sums.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::integration {

void GuardSums::note_exponent(std::size_t place) {
  if (rate[place] != 0)
    decaying.push_back(place);
  if (frequency[place] != 0)
    oscillating.push_back(place);
  const double square = rate[place] * rate[place] + frequency[place] * frequency[place];
  fastest = std::max(fastest, std::sqrt(square));
}

void GuardSums::add_exponent(std::complex<double> exponent) {
  rate.push_back(exponent.real());
  frequency.push_back(exponent.imag());
  note_exponent(rate.size() - 1);
}

void GuardSums::set_exponents(std::size_t first, std::span<const std::complex<double>> exponents) {
  for (std::size_t j = 0; j < exponents.size(); ++j) {
    rate[first + j] = exponents[j].real();
    frequency[first + j] = exponents[j].imag();
  }
  decaying.clear();
  oscillating.clear();
  fastest = 0;
  for (std::size_t j = 0; j < rate.size(); ++j)
    note_exponent(j);
}

void GuardSums::add_guard(double constant_term, std::span<const std::complex<double>> coefficients,
                          std::span<const double> sizes) {
  constant.push_back(constant_term);
  const std::size_t count = constant.size() * n_groups();
  for (std::vector<double> *list : {&real, &imaginary, &size, &fourth})
    list->resize(count);
  for (std::size_t j = 0; j < coefficients.size(); ++j)
    set_coefficient(constant.size() - 1, j, coefficients[j], sizes[j]);
}

void GuardSums::set_coefficient(std::size_t guard, std::size_t exponent,
                                std::complex<double> coefficient, double size_behind) {
  const std::size_t place = guard * n_groups() + exponent;
  const double square = rate[exponent] * rate[exponent] + frequency[exponent] * frequency[exponent];
  real[place] = coefficient.real();
  imaginary[place] = coefficient.imag();
  size[place] = size_behind;
  fourth[place] = std::sqrt(std::norm(coefficient)) * square * square;
}

} // namespace vibroimpact::integration
