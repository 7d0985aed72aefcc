// Polynomials in Bernstein form: division by a zero at the start, and the zero of one that changes
// its sign once; included by the kernel_*.cc only.
#pragma once

#include "motion/exact/kernel.h"

namespace vibroimpact::motion {
namespace {

/// Where a guard falls through zero.
struct Zero {
  int guard = -1;
  double tau = 0, zone = 0; ///< in the piece; it is as near as that
  bool proven = false;      ///< to be the only one of its guard
};

// Division of Bernstein coefficients by tau and tau^2: b_i becomes b_i 7 / i and b_i 42 / (i (i -
// 1)).
constexpr double order_weights[largest_order][8] = {
    {0, 7, 7.0 / 2, 7.0 / 3, 7.0 / 4, 7.0 / 5, 7.0 / 6, 1}, {0, 0, 21, 7, 3.5, 2.1, 1.4, 1}};
// Their largest entries, by which rounding grows.
constexpr double order_factor[] = {1, 7, 21};

// The set bits reach without a gap up to the highest of the eight.
inline bool contiguous(unsigned mask) {
  const unsigned above = mask | (mask - 1);
  return (mask & 0x80) != 0 && above == 0xff;
}

// a_k = C(n, k) sum over i <= k of (-1)^(k - i) C(k, i) b_i
inline void power_form(const double *b, int degree, double *power) {
  double difference[8];
  for (int i = 0; i <= degree; ++i)
    difference[i] = b[i];
  double binomial = 1;
  for (int k = 0; k <= degree; ++k) {
    power[k] = binomial * difference[0];
    for (int i = 0; i + k < degree; ++i)
      difference[i] = difference[i + 1] - difference[i];
    binomial = binomial * (degree - k) / (k + 1);
  }
}

// The only zero of a polynomial given by Bernstein coefficients of degree 7 - r: from where its
// control polygon crosses, by Halley's method in a bracket.
inline Zero polynomial_zero(int guard, int r, const double *b, unsigned low, double e) {
  const int degree = table_degree - r;
  const int i0 = __builtin_ctz(low);
  double x = (i0 - 1 - r + b[i0 - 1] / (b[i0 - 1] - b[i0])) / degree;
  double lower = 0;
  double upper = 1;
  double slope = 0;
  double power[8];
  power_form(b + r, degree, power);
  for (int i = 0; i < 30; ++i) {
    double p = power[degree];
    double d = 0;
    double s = 0; // half the second derivative
    for (int j = degree - 1; j >= 0; --j) {
      s = s * x + d;
      d = d * x + p;
      p = p * x + power[j];
    }
    slope = d;
    (p > 0 ? lower : upper) = x;
    const double step = p * d / (d * d - p * s);
    double next = x - step;
    if (!(next >= lower && next <= upper))
      next = 0.5 * (lower + upper);
    const double moved = next > x ? next - x : x - next;
    x = next;
    if (moved < 3e-3) // the next one would be its cube
      break;
  }
  const double zone = slope < 0 ? -e / slope : 1;
  return {.guard = guard, .tau = x, .zone = zone};
}

} // namespace
} // namespace vibroimpact::motion
