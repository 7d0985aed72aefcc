// Guards as sums of exponentials, as plain arrays.
//
//   f_g(t) = constant_g + Re sum_j coefficient_gj amplitude_j exp(exponent_j t)
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace vibroimpact::integration {

/// Amplitudes of the groups of a phase, and their absolute values.
struct Amplitudes {
  std::vector<double> real, imaginary, size;

  void resize(std::size_t count) {
    real.resize(count);
    imaginary.resize(count);
    size.resize(count);
  }
};

struct GuardSums {
  std::vector<double> rate, frequency; ///< real and imaginary part of the exponents [1/s]
  std::vector<std::size_t> decaying, oscillating; ///< exponents with a rate, with a frequency
  double fastest = 0;                             ///< largest absolute value of the exponents [1/s]
  std::vector<double> constant;                   ///< of the guards
  // guards x exponents
  std::vector<double> real, imaginary; ///< coefficients
  std::vector<double> fourth;          ///< |coefficient| |exponent|^4
  std::vector<double> size;            ///< sums of the absolute values behind the coefficients

  std::size_t n_guards() const { return constant.size(); }
  std::size_t n_groups() const { return rate.size(); }

  /// All exponents before the first guard.
  void add_exponent(std::complex<double> exponent);
  /// Other exponents in place of those from `first` on; their coefficients are to be set again.
  void set_exponents(std::size_t first, std::span<const std::complex<double>> exponents);
  /// One coefficient per exponent; `sizes`: of what each was summed up from, for the rounding.
  void add_guard(double constant_term, std::span<const std::complex<double>> coefficients,
                 std::span<const double> sizes);
  /// Another coefficient of a guard that is there.
  void set_coefficient(std::size_t guard, std::size_t exponent, std::complex<double> coefficient,
                       double size_behind);

private:
  void note_exponent(std::size_t place);
};

} // namespace vibroimpact::integration
