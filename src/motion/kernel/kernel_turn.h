// Amplitudes that go on, and linear forms of them; included by the kernel_*.cc only.
#pragma once

#include "motion/kernel/kernel.h"
#include "motion/kernel/vector8.h"

namespace vibroimpact::motion {
namespace {

constexpr double epsilon = 0x1p-52;
/// Times by the fastest exponent: below the first two steps of Taylor's series to the third order
/// are exact, below the second the result needs no further correction.
constexpr double little_turn = 2e-4;
constexpr double final_turn = 6e-6;

// The columns of a dense block, by its exponential `e`.
inline void turn_dense(const double *e, const DenseBlockView &block, const double *from,
                       double *to) {
  for (int i = 0; i < block.size; ++i) {
    double s = 0;
    for (int j = 0; j < block.size; ++j)
      s += e[i * block.size + j] * from[block.first + j];
    to[block.first + i] = s;
  }
}

// exp(e t) of eight groups.
inline void factors(const PhaseView &p, int b, double t, V8 &real, V8 &imaginary) {
  const V8 size = exponential(load(p.rate + b) * all(t));
  const V8 angle = load(p.frequency + b) * all(t);
  if (below(all(largest_angle), magnitude(angle)) == 0) {
    const SineCosine8 turned = sine_cosine(angle);
    // What rounding has taken from the angle, which counts after many periods.
    const V8 lost = all(0) - fused_minus(load(p.frequency + b), all(t), angle);
    real = size * fused_minus(turned.sine, lost, turned.cosine);
    imaginary = size * fused(turned.cosine, lost, turned.sine);
    return;
  }
  double x[8];
  double c[8];
  double s[8];
  store(x, angle);
  for (int i = 0; i < 8; ++i) {
    c[i] = __builtin_cos(x[i]);
    s[i] = __builtin_sin(x[i]);
  }
  real = size * load(c);
  imaginary = size * load(s);
}

inline void turn(const PhaseView &p, const double *from, double t, double *to) {
  const int n = p.n_padded;
  for (int b = 0; b < n; b += group_block) {
    V8 c;
    V8 s;
    factors(p, b, t, c, s);
    const V8 re = load(from + b);
    const V8 im = load(from + n + b);
    store(to + b, fused_minus(im, s, re * c));
    store(to + n + b, fused(im, c, re * s));
  }
  for (int d = 0; d < p.n_dense; ++d) {
    const DenseBlockView &block = p.dense[d];
    turn_dense_block(block.generator, block.size, t, from + block.first, to + block.first);
  }
}

// On by t, |e t| <= little_turn: 1 + w + w^2/2 + w^3/6 with w = e t.
inline void turn_little(const PhaseView &p, double t, double *amplitudes) {
  const int n = p.n_padded;
  for (int b = 0; b < n; b += group_block) {
    const V8 x = load(p.rate + b) * all(t);
    const V8 y = load(p.frequency + b) * all(t);
    // 1 + w (1 + w/2 (1 + w/3))
    V8 c = fused(x, all(1.0 / 3), all(1));
    V8 s = y * all(1.0 / 3);
    V8 next = fused_minus(y, s, x * c) * all(0.5) + all(1);
    s = fused(y, c, x * s) * all(0.5);
    c = next;
    next = fused_minus(y, s, x * c);
    s = fused(y, c, x * s);
    c = next; // less one, so that nothing is lost
    const V8 re = load(amplitudes + b);
    const V8 im = load(amplitudes + n + b);
    store(amplitudes + b, re + fused_minus(im, s, re * c));
    store(amplitudes + n + b, im + fused(im, c, re * s));
  }
  for (int d = 0; d < p.n_dense; ++d) {
    const DenseBlockView &block = p.dense[d];
    turn_dense_block(block.generator, block.size, t, amplitudes + block.first,
                     amplitudes + block.first);
  }
}

// The first `count` derivatives of a linear form, but for its constant.
template <int count>
inline void sum_rows(const double *rows, int n, const double *amplitudes, double *values) {
  V8 s[count];
  for (int r = 0; r < count; ++r)
    s[r] = all(0);
  for (int b = 0; b < n; b += group_block) {
    const V8 re = load(amplitudes + b);
    const V8 im = load(amplitudes + n + b);
    for (int r = 0; r < count; ++r) {
      s[r] = fused(load(rows + 2 * r * n + b), re, s[r]);
      s[r] = fused(load(rows + (2 * r + 1) * n + b), im, s[r]);
    }
  }
  for (int r = 0; r < count; ++r)
    values[r] = sum(s[r]);
}

inline void change(const ChangeView &change, const double *from, double *to, double *rounding) {
  const int n = change.n_padded;
  for (int b = 0; b < n; b += group_block) {
    V8 re = load(change.constant + b);
    V8 im = load(change.constant + n + b);
    V8 size = load(change.constant_sizes + b);
    const double *column = change.columns + b;
    const double *of_sizes = change.magnitudes + b;
    for (int j = 0; j < change.n_columns; ++j) {
      const V8 x = all(from[change.places[j]]);
      re = fused(load(column), x, re);
      im = fused(load(column + n), x, im);
      size = fused(load(of_sizes), magnitude(x), size);
      column += 2 * n;
      of_sizes += n;
    }
    store(to + b, re);
    store(to + n + b, im);
    store(rounding + b, size * all(8 * epsilon));
  }
}

struct Product {
  double real, imaginary;
};

inline Product product(const ProductView &of, int n, const double *a) {
  const double x = a[of.first];
  const double y = a[n + of.first];
  const double u = a[of.second];
  const double v = of.conjugate ? -a[n + of.second] : a[n + of.second];
  return {x * u - y * v, x * v + y * u};
}

// [z_i z_j] / (e_i + e_j), the division being in the coefficients; the trapezoidal rule with its
// first correction where the sum is next to zero.
inline void integrate(const WorkView &work, const double *from, const double *to, double length,
                      double *integrals) {
  for (int block = 0; block < work.n_blocks; ++block) {
    V8 real = all(0);
    V8 imaginary = all(0);
    const double *c = work.coefficients + 16 * block * work.n_products;
    for (int k = 0; k < work.n_products; ++k, c += 16) {
      const ProductView &p = work.products[k];
      const Product a = product(p, work.n_padded, from);
      const Product b = product(p, work.n_padded, to);
      Product d{b.real - a.real, b.imaginary - a.imaginary};
      if (p.is_slow) {
        const double half = 0.5 * length;
        const double twelfth = length * length / 12;
        d = {half * (a.real + b.real) -
                 twelfth * (p.sum_real * d.real - p.sum_imaginary * d.imaginary),
             half * (a.imaginary + b.imaginary) -
                 twelfth * (p.sum_real * d.imaginary + p.sum_imaginary * d.real)};
      }
      real = fused(load(c), all(d.real), real);
      imaginary = fused(load(c + 8), all(d.imaginary), imaginary);
    }
    store(integrals + 8 * block, real - imaginary);
  }
}

} // namespace
} // namespace vibroimpact::motion
