// Numbers that carry their derivatives along: x + x_1 e_1 + ... + x_n e_n with e_i e_j = 0. What is
// calculated with them has the derivatives of the calculation itself.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace vibroimpact::testing {

struct Dual {
  static constexpr std::size_t most = 15;

  double value = 0;
  std::array<double, most> by{};

  Dual() = default;
  Dual(double number) : value(number) {} // NOLINT: numbers are constants

  /// `number` as the variable of the given place.
  static Dual variable(double number, std::size_t place) {
    Dual dual(number);
    dual.by.at(place) = 1;
    return dual;
  }

  /// f(x) where f has this value and slope.
  Dual map(double f, double slope) const {
    Dual result(f);
    for (std::size_t i = 0; i < most; ++i)
      result.by[i] = slope * by[i];
    return result;
  }
  Dual &operator+=(const Dual &other) {
    value += other.value;
    for (std::size_t i = 0; i < most; ++i)
      by[i] += other.by[i];
    return *this;
  }
  Dual &operator*=(const Dual &other) {
    for (std::size_t i = 0; i < most; ++i)
      by[i] = by[i] * other.value + value * other.by[i];
    value *= other.value;
    return *this;
  }
};

inline Dual operator+(Dual a, const Dual &b) { return a += b; }
inline Dual operator-(const Dual &a) { return a.map(-a.value, -1); }
inline Dual operator-(const Dual &a, const Dual &b) { return a + -b; }
inline Dual operator*(Dual a, const Dual &b) { return a *= b; }
inline Dual operator/(const Dual &a, const Dual &b) {
  return a * b.map(1 / b.value, -1 / (b.value * b.value));
}
inline Dual sin(const Dual &a) { return a.map(std::sin(a.value), std::cos(a.value)); }
inline Dual cos(const Dual &a) { return a.map(std::cos(a.value), -std::sin(a.value)); }
/// Of positive numbers.
inline Dual pow(const Dual &a, double exponent) {
  const double power = std::pow(a.value, exponent);
  return a.map(power, exponent * power / a.value);
}
inline Dual sqrt(const Dual &a) { return pow(a, 0.5); }

} // namespace vibroimpact::testing
