// Polynomials in Bernstein form: division by a zero at the start, and the zero of one that changes
// its sign once; included by the kernel_*.cc only.
#pragma once

#include "motion/kernel/kernel.h"
#include "motion/kernel/vector8.h"

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

// The set bits reach without a gap up to the highest of `coefficients`, which are the lowest bits.
inline bool contiguous(unsigned mask, unsigned coefficients) {
  const unsigned above = mask | (mask - 1);
  return (mask & (coefficients ^ (coefficients >> 1))) != 0 && above == coefficients;
}

constexpr double binomial(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; ++i)
    value = value * (n - k + i) / i;
  return value;
}

/// What each of the Bernstein coefficients b_r ... b_7 of a polynomial of degree n = 7 - r adds to
/// its coefficients by powers: a_k = C(n, k) sum over i <= k of (-1)^(k - i) C(k, i) b_{i + r}.
struct PowerColumns {
  double column[largest_order + 1][8][8] = {};

  constexpr PowerColumns() {
    for (int r = 0; r <= largest_order; ++r)
      for (int i = 0; i <= table_degree - r; ++i)
        for (int k = i; k <= table_degree - r; ++k)
          column[r][i + r][k] =
              ((k - i) % 2 == 0 ? 1 : -1) * binomial(table_degree - r, k) * binomial(k, i);
  }
};
constexpr PowerColumns power_columns;

// Factors of the coefficients by powers in the derivative, and in half the second one.
constexpr double slope_factors[8] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr double bend_factors[8] = {0, 0, 1, 3, 6, 10, 15, 21};

/// A polynomial of degree 7 by powers, with its derivatives.
class Polynomial {
public:
  Polynomial(const double *b, int r) {
    V8 even = all(0);
    V8 odd = all(0);
    for (int i = r & ~1; i < 8; i += 2) {
      even = fused(all(b[i]), load(power_columns.column[r][i]), even);
      odd = fused(all(b[i + 1]), load(power_columns.column[r][i + 1]), odd);
    }
    const V8 powers = even + odd;
    store(value_, powers);
    store(slope_, powers * load(slope_factors));
    store(bend_, powers * load(bend_factors));
  }

  /// Value, derivative and half the second derivative.
  void operator()(double x, double &value, double &slope, double &bend) const {
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double *a = value_;
    const double *b = slope_;
    const double *c = bend_;
    value = fused(fused(fused(a[7], x, a[6]), x2, fused(a[5], x, a[4])), x4,
                  fused(fused(a[3], x, a[2]), x2, fused(a[1], x, a[0])));
    slope = fused(fused(b[7], x2, fused(b[6], x, b[5])), x4,
                  fused(fused(b[4], x, b[3]), x2, fused(b[2], x, b[1])));
    bend = fused(fused(c[7], x, c[6]), x4, fused(fused(c[5], x, c[4]), x2, fused(c[3], x, c[2])));
  }

private:
  double value_[8], slope_[8], bend_[8];
};

// Where a control polygon of b_r ... b_last crosses zero, `low` being the first that is not above.
inline double crossing_of(const double *b, int r, int last, unsigned low) {
  const int i0 = __builtin_ctz(low);
  return (i0 - 1 - r + b[i0 - 1] / (b[i0 - 1] - b[i0])) / (last - r);
}

// The only zero of a polynomial, which falls there, by Halley's method in a bracket, from x on; e:
// its error.
template <class Function>
inline Zero polynomial_zero(int guard, const Function &polynomial, double x, double e) {
  double lower = 0;
  double upper = 1;
  double slope = 0;
  bool settled = false;
  for (int i = 0; i < 30; ++i) {
    double p = 0;
    double bend = 0;
    polynomial(x, p, slope, bend);
    (p > 0 ? lower : upper) = x;
    double next = x - p * slope / (slope * slope - p * bend);
    if (!(next >= lower && next <= upper))
      next = 0.5 * (lower + upper);
    const double moved = next > x ? next - x : x - next;
    x = next;
    // What is left is its cube over the square of slope / bend, the distance at which the slope
    // vanishes, which is short where the zero lies in a small part of a long piece.
    const double larger =
        __builtin_fabs(bend) > __builtin_fabs(slope) ? __builtin_fabs(bend) : __builtin_fabs(slope);
    settled = moved * larger < 3e-3 * __builtin_fabs(slope);
    if (settled)
      break;
  }
  const double zone = settled && slope < 0 ? -e / slope : 1;
  return {.guard = guard, .tau = x, .zone = zone};
}

} // namespace
} // namespace vibroimpact::motion
