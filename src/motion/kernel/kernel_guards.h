// Guards of a phase: values, and what bounds them over a piece; included by the kernel_*.cc only.
//
// A guard that is a sum of squares has, over a piece, the square of each form's polynomial, of
// degree 14. With the errors E_r of the forms, |f - p| <= tau^r E_r,
//
//   |f^2 - p^2| / tau^r <= E_r (2 max|p| + E_0)
//
// and likewise for what rounding makes of them.
#pragma once

#include "motion/kernel/kernel_turn.h"
#include "motion/kernel/kernel_zero.h"

namespace vibroimpact::motion {
namespace {

constexpr double interpolation_rounding = 128 * epsilon;
constexpr int n_squares = 3;

inline const SquaresView *squares_of(const PhaseView &p, int guard) {
  return p.squares && guard < p.n_guards && p.squares[guard].first > 0 ? p.squares + guard
                                                                       : nullptr;
}

inline double factor(const SquaresView &squares, int i) {
  return i == 0 ? squares.scale : -squares.scale;
}

// The first `count` derivatives of a form.
template <int count>
inline void form_derivatives(const PhaseView &p, int form, const double *amplitudes,
                             double *values) {
  sum_rows<count>(p.rows + form * 8 * p.n_padded, p.n_padded, amplitudes, values);
  values[0] += p.constants[form];
}

// (f^2)' = 2 f f', (f^2)'' = 2 (f'^2 + f f''), (f^2)''' = 2 (3 f' f'' + f f''')
template <int count>
inline void guard_derivatives(const PhaseView &p, int guard, const double *amplitudes,
                              double *values) {
  const SquaresView *squares = squares_of(p, guard);
  if (!squares) {
    form_derivatives<count>(p, guard, amplitudes, values);
    return;
  }
  for (int r = 0; r < count; ++r)
    values[r] = 0;
  for (int i = 0; i < n_squares; ++i) {
    double f[4] = {0, 0, 0, 0};
    form_derivatives<count>(p, squares->first + i, amplitudes, f);
    const double c = factor(*squares, i);
    const double of_square[4] = {f[0] * f[0], 2 * f[0] * f[1], 2 * (f[1] * f[1] + f[0] * f[2]),
                                 2 * (3 * f[1] * f[2] + f[0] * f[3])};
    for (int r = 0; r < count; ++r)
      values[r] += c * of_square[r];
  }
}

inline void derivatives(const PhaseView &p, int guard, const double *amplitudes, double *values) {
  guard_derivatives<4>(p, guard, amplitudes, values);
}

inline void low_derivatives(const PhaseView &p, int guard, const double *amplitudes,
                            double *values) {
  guard_derivatives<2>(p, guard, amplitudes, values);
}

// What a form is summed up from.
inline double form_size(const PhaseView &p, int form, const double *amplitudes) {
  const int n = p.n_padded;
  const double *sizes = p.sizes + form * n;
  V8 total = all(0);
  for (int b = 0; b < n; b += group_block) {
    const V8 re = load(amplitudes + b);
    const V8 im = load(amplitudes + n + b);
    total = fused(load(sizes + b), square_root(fused(re, re, im * im)), total);
  }
  return p.constant_sizes[form] + sum(total);
}

inline double guard_margin(const PhaseView &p, int guard, const double *amplitudes,
                           const double *noise) {
  const SquaresView *squares = squares_of(p, guard);
  if (!squares)
    return guard_rounding * form_size(p, guard, amplitudes) + noise[guard];
  // Where the sum is not below zero, the first form is the largest of them.
  const double largest = form_size(p, squares->first, amplitudes);
  double total = 0;
  for (int i = 0; i < n_squares; ++i) {
    const double size = i == 0 ? largest : form_size(p, squares->first + i, amplitudes);
    const double error = guard_rounding * size + noise[squares->first + i];
    total += error * (2 * largest + error);
  }
  return __builtin_fabs(squares->scale) * total;
}

inline void form_noise(const PhaseView &phase, const double *rounding, double *noise) {
  for (int form = 0; form < phase.n_forms; ++form) {
    V8 total = all(0);
    for (int b = 0; b < phase.n_padded; b += group_block)
      total = fused(load(phase.sizes + form * phase.n_padded + b), load(rounding + b), total);
    noise[form] = sum(total);
  }
}

// Binomial coefficients C(7, i), and 1 / C(14, k), the last one twice.
constexpr double of_degree_7[8] = {1, 7, 21, 35, 35, 21, 7, 1};
struct DegreesOfSquares {
  double inverse[16] = {};
  double order_weights[largest_order][16] = {}; ///< division by tau and tau^2

  constexpr DegreesOfSquares() {
    for (int k = 0; k < 16; ++k) {
      const int j = k < 15 ? k : 14;
      inverse[k] = 1 / binomial(14, j);
      order_weights[0][k] = j > 0 ? 14.0 / j : 0;
      order_weights[1][k] = j > 1 ? 14.0 * 13.0 / (j * (j - 1)) : 0;
    }
  }
};
constexpr DegreesOfSquares of_squares;
constexpr unsigned coefficients_of_square = 0x7fff;
// By which division by tau^r makes rounding larger, over the same of degree 7: 14/7, 91/21.
constexpr double square_order_factor[] = {1, 2, 5};

/// The forms of a guard that is a sum of squares, over a piece: Bernstein coefficients.
struct SquaresOverPiece {
  const SquaresView *squares = nullptr;
  double forms[n_squares][8];

  /// Of the sum, degree 14, 16 of them, the last one twice.
  void coefficients(double *sum) const {
    double wide[24] = {};
    for (int i = 0; i < n_squares; ++i) {
      const V8 weighted = load(forms[i]) * load(of_degree_7);
      double c[8];
      store(c, weighted * all(factor(*squares, i)));
      for (int j = 0; j < 8; ++j)
        store(wide + j, fused(all(c[j]), weighted, load(wide + j)));
    }
    wide[15] = wide[14];
    store(sum, load(wide) * load(of_squares.inverse));
    store(sum + 8, load(wide + 8) * load(of_squares.inverse + 8));
  }

  double largest(int i) const {
    double most = 0;
    for (const double b : forms[i])
      most = __builtin_fabs(b) > most ? __builtin_fabs(b) : most;
    return most;
  }
};

/// The sum of squares divided by tau^r, with its derivatives.
class SquaresPolynomial {
public:
  SquaresPolynomial(const SquaresOverPiece &piece, int r)
      : squares_(*piece.squares),
        order_(r), forms_{Polynomial(piece.forms[0], 0), Polynomial(piece.forms[1], 0),
                          Polynomial(piece.forms[2], 0)} {}

  /// Value, derivative and half the second derivative, x > 0.
  void operator()(double x, double &value, double &slope, double &bend) const {
    value = slope = bend = 0;
    for (int i = 0; i < n_squares; ++i) {
      double f = 0;
      double f1 = 0;
      double f2 = 0;
      forms_[i](x, f, f1, f2);
      const double c = factor(squares_, i);
      value += c * f * f;
      slope += 2 * c * f * f1;
      bend += c * (f1 * f1 + 2 * f * f2);
    }
    for (int r = 0; r < order_; ++r) { // q = p / x: q' = (p' - q) / x, q''/2 = (p''/2 - q') / x
      value /= x;
      slope = (slope - value) / x;
      bend = (bend - slope) / x;
    }
  }

private:
  const SquaresView &squares_;
  int order_;
  Polynomial forms_[n_squares];
};

/// What bounds the guards of a phase over the present piece of a march, whose reach is known.
class GuardBounds {
protected:
  GuardBounds(const PhaseView &phase, MarchState &walk) : p_(phase), w_(walk) {}

  double margin(int guard) const { return guard_margin(p_, guard, w_.amplitudes, w_.noise); }

  double weighted(const double *weights, const double *magnitudes) const {
    V8 s = all(0);
    for (int b = 0; b < p_.n_padded; b += group_block)
      s = fused(load(weights + b), load(magnitudes + b), s);
    return sum(s);
  }

  V8 coefficients(const LevelView &l, int form) const {
    const double *t = l.table + form * (p_.n_groups + p_.n_pairs) * 8;
    const double *re = w_.amplitudes;
    const double *im = w_.amplitudes + p_.n_padded;
    V8 even = all(p_.constants[form]);
    V8 odd = all(0);
    int j = 0;
    for (; j + 1 < p_.n_groups; j += 2) {
      even = fused(all(re[j]), load(t + 8 * j), even);
      odd = fused(all(re[j + 1]), load(t + 8 * j + 8), odd);
    }
    if (j < p_.n_groups)
      even = fused(all(re[j]), load(t + 8 * j), even);
    t += 8 * p_.n_groups;
    for (j = 0; j + 1 < p_.n_pairs; j += 2) {
      even = fused(all(im[j]), load(t + 8 * j), even);
      odd = fused(all(im[j + 1]), load(t + 8 * j + 8), odd);
    }
    if (j < p_.n_pairs)
      odd = fused(all(im[j]), load(t + 8 * j), odd);
    return even + odd;
  }

  SquaresOverPiece over_piece(const LevelView &l, const SquaresView &squares) const {
    SquaresOverPiece piece;
    piece.squares = &squares;
    for (int i = 0; i < n_squares; ++i)
      store(piece.forms[i], coefficients(l, squares.first + i));
    return piece;
  }

  double form_error(const LevelView &l, int form, int order) const {
    const double *bounds = l.bounds + (form * (largest_order + 1) + order) * p_.n_padded;
    return weighted(bounds, w_.reach) +
           order_factor[order] *
               (interpolation_rounding * p_.constant_sizes[form] + w_.noise[form]);
  }

  double error(const LevelView &l, const SquaresOverPiece &piece, int order) const {
    double total = 0;
    for (int i = 0; i < n_squares; ++i) {
      const int form = piece.squares->first + i;
      total += form_error(l, form, order) * (2 * piece.largest(i) + form_error(l, form, 0));
    }
    return square_order_factor[order] * __builtin_fabs(piece.squares->scale) * total;
  }

  double error(const LevelView &l, int guard, int order) const {
    const SquaresView *squares = squares_of(p_, guard);
    return squares ? error(l, over_piece(l, *squares), order) : form_error(l, guard, order);
  }

  double rounding_of_form(int form) const {
    return interpolation_rounding *
           (weighted(p_.sizes + form * p_.n_padded, w_.reach) + p_.constant_sizes[form]);
  }

  // Most of the error of the polynomial comes from rounding.
  bool by_rounding(const LevelView &l, const Zero &zero) const {
    const SquaresView *squares = squares_of(p_, zero.guard);
    if (!squares)
      return form_error(l, zero.guard, 0) <=
             4 * rounding_of_form(zero.guard) + w_.noise[zero.guard];
    const SquaresOverPiece piece = over_piece(l, *squares);
    double total = 0;
    for (int i = 0; i < n_squares; ++i) {
      const int form = squares->first + i;
      const double of_form = 4 * rounding_of_form(form) + w_.noise[form];
      total += of_form * (2 * piece.largest(i) + of_form);
    }
    return error(l, piece, 0) <= __builtin_fabs(squares->scale) * total;
  }

  /// Of a form, by the arrays of a derivative.
  double bound(const double *of_forms, int form) const {
    return weighted(of_forms + form * p_.n_padded, w_.reach);
  }

  double second_derivative(int guard) const {
    const SquaresView *squares = squares_of(p_, guard);
    if (!squares)
      return bound(p_.second, guard);
    double total = 0;
    for (int i = squares->first; i < squares->first + n_squares; ++i) {
      const double slope = bound(p_.slopes, i);
      total += slope * slope + value(i) * bound(p_.second, i);
    }
    return 2 * __builtin_fabs(squares->scale) * total;
  }

  double third_derivative(int guard) const {
    const SquaresView *squares = squares_of(p_, guard);
    if (!squares)
      return bound(p_.third, guard);
    double total = 0;
    for (int i = squares->first; i < squares->first + n_squares; ++i)
      total += 3 * bound(p_.slopes, i) * bound(p_.second, i) + value(i) * bound(p_.third, i);
    return 2 * __builtin_fabs(squares->scale) * total;
  }

  const PhaseView &p_;
  MarchState &w_;

private:
  double value(int form) const { return bound(p_.sizes, form) + p_.constant_sizes[form]; }
};

} // namespace
} // namespace vibroimpact::motion
