// Extreme values of linear forms over pieces; included by the kernel_*.cc only.
//
// What oscillates in a form, f_P, lies within h^6 M / 46080 of the quintic q with its values,
// slopes and curvatures at both ends of a piece, the slope within sqrt(5) h^5 M / 30000 and the
// curvature within h^4 M / 1920 of that quintic's, M being a bound of the sixth derivative. Real
// exponentials are monotone, and so are their derivatives: they lie between their values at the
// ends.
#pragma once

#include "motion/exact/kernel_turn.h"

namespace vibroimpact::motion {
namespace {

constexpr double value_error = 1.0 / 46080;
constexpr double slope_error = 2.23606797749979 / 30000;
constexpr double curvature_error = 1.0 / 1920;
constexpr double output_rounding = 16 * epsilon;

/// An interval for what real exponentials add.
struct Interval {
  double lower = 0, upper = 0;
};

/// One form over one piece.
class OutputSearch {
public:
  OutputSearch(const PhaseView &phase, OutputsView &outputs, int output, const double *start,
               double *scratch, double sixth, double rounding)
      : p_(phase), o_(outputs), output_(output), start_(start), now_(scratch), sixth_(sixth),
        rounding_(rounding), rows_(outputs.single + output * 8 * phase.n_padded) {}

  void include(double from, double to, int halvings) {
    const double h = to - from;
    double first[6];
    double last[6];
    split(from, first);
    split(to, last);
    double b[6];
    bernstein(first, last, h, b);
    const double error = sixth_ * h * h * h * h * h * h;
    const Interval value = between(from, to, 0);
    if (highest(b, 6) + error * value_error + value.upper <= o_.maximum[output_] + rounding_ &&
        lowest(b, 6) - error * value_error + value.lower >= o_.minimum[output_] - rounding_)
      return;
    double slope[5];
    for (int i = 0; i < 5; ++i)
      slope[i] = 5 * (b[i + 1] - b[i]) / h;
    const Interval real_slope = between(from, to, 1);
    const double of_slope = error * slope_error / h;
    if (lowest(slope, 5) - of_slope + real_slope.lower > 0 ||
        highest(slope, 5) + of_slope + real_slope.upper < 0)
      return;
    double bend[4];
    for (int i = 0; i < 4; ++i)
      bend[i] = 4 * (slope[i + 1] - slope[i]) / h;
    const Interval real_bend = between(from, to, 2);
    const double of_bend = error * curvature_error / (h * h);
    if (lowest(bend, 4) - of_bend + real_bend.lower > 0 ||
        highest(bend, 4) + of_bend + real_bend.upper < 0) {
      const double s0 = first[1] + first[4];
      const double s1 = last[1] + last[4];
      if ((s0 > 0) != (s1 > 0))
        include_turn(from, to, s0, s1, s0 > 0);
      return;
    }
    const double middle = from + 0.5 * h;
    if (halvings == most_halvings_ || !(middle > from && middle < to))
      return;
    double f[4];
    values(middle, f);
    note(f[0]);
    include(from, middle, halvings + 1);
    include(middle, to, halvings + 1);
  }

private:
  void values(double t, double *f) {
    turn(p_, start_, t, now_);
    sum_rows<4>(rows_, p_.n_padded, now_, f);
    f[0] += o_.constants[output_];
  }

  void note(double value) {
    if (value > o_.maximum[output_])
      o_.maximum[output_] = value;
    if (value < o_.minimum[output_])
      o_.minimum[output_] = value;
  }

  // Value, slope and curvature of what oscillates, the constant with it, then of what decays.
  void split(double t, double *parts) {
    turn(p_, start_, t, now_);
    for (int r = 0; r < 3; ++r) {
      const double *re = rows_ + 2 * r * p_.n_padded;
      const double *im = re + p_.n_padded;
      double pairs = r == 0 ? o_.constants[output_] : 0;
      double reals = 0;
      for (int j = 0; j < p_.n_groups; ++j) {
        const double x = re[j] * now_[j] + im[j] * now_[p_.n_padded + j];
        (is_real(j) ? reals : pairs) += x;
      }
      parts[r] = pairs;
      parts[3 + r] = reals;
    }
  }

  bool is_real(int j) const { return j >= p_.n_pairs && p_.rate[j] != 0; }

  // Each real exponential lies between its values at the ends; so does their sum between the sums.
  Interval between(double from, double to, int r) const {
    Interval sum;
    const double *re = rows_ + 2 * r * p_.n_padded;
    for (int j = p_.n_pairs; j < p_.n_groups; ++j)
      if (is_real(j)) {
        const double amplitude = re[j] * start_[j];
        const double begin = amplitude * __builtin_exp(p_.rate[j] * from);
        const double end = amplitude * __builtin_exp(p_.rate[j] * to);
        sum.lower += begin < end ? begin : end;
        sum.upper += begin < end ? end : begin;
      }
    return sum;
  }

  static void bernstein(const double *a, const double *z, double h, double *b) {
    b[0] = a[0];
    b[1] = a[0] + h / 5 * a[1];
    b[2] = a[0] + h * (0.4 * a[1] + h / 20 * a[2]);
    b[3] = z[0] - h * (0.4 * z[1] - h / 20 * z[2]);
    b[4] = z[0] - h / 5 * z[1];
    b[5] = z[0];
  }

  static double lowest(const double *b, int count) {
    double least = b[0];
    for (int i = 1; i < count; ++i)
      least = b[i] < least ? b[i] : least;
    return least;
  }
  static double highest(const double *b, int count) {
    double most = b[0];
    for (int i = 1; i < count; ++i)
      most = b[i] > most ? b[i] : most;
    return most;
  }

  // The only turning point of the interval: Halley's method for the slope, in a bracket. As far
  // from it as d the value lacks f' d + f'' d^2 / 2 + f''' d^3 / 6.
  void include_turn(double from, double to, double slope_from, double slope_to, bool rises) {
    double lower = from;
    double upper = to;
    double t = from + (to - from) * slope_from / (slope_from - slope_to);
    for (int i = 0; i < most_corrections_; ++i) {
      double f[4];
      values(t, f);
      note(f[0]);
      double d = -f[1] / f[2];
      d = d / (1 + 0.5 * d * f[3] / f[2]);
      const double size = d < 0 ? -d : d;
      if (f[1] * f[1] <= rounding_ * (f[2] < 0 ? -f[2] : f[2]))
        return;
      if (size * p_.fastest < 3e-4 && t + d > from && t + d < to) {
        note(f[0] + d * (f[1] + d * (0.5 * f[2] + d / 6 * f[3])));
        return;
      }
      ((f[1] > 0) == rises ? lower : upper) = t;
      double next = t + d;
      if (!(next > lower && next < upper))
        next = 0.5 * (lower + upper);
      if (next == t)
        return;
      t = next;
    }
  }

  static constexpr int most_halvings_ = 60;
  static constexpr int most_corrections_ = 60;

  const PhaseView &p_;
  OutputsView &o_;
  int output_;
  const double *start_;
  double *now_;
  double sixth_, rounding_;
  const double *rows_;
};

/// Value, slope and curvature of eight forms at one instant, without their constants.
struct Output8 {
  V8 oscillating[3], decaying[3];
};

inline V8 load_at(const double *rows, int r, int part, int n, int j) {
  return load(rows + 8 * ((2 * r + part) * n + j));
}

inline void sum_output(const PhaseView &p, const double *rows, const double *amplitudes,
                       Output8 &f) {
  const int n = p.n_padded;
  for (int r = 0; r < 3; ++r) {
    V8 pairs = all(0);
    for (int j = 0; j < p.n_pairs; ++j) {
      pairs = fused(load_at(rows, r, 0, n, j), all(amplitudes[j]), pairs);
      pairs = fused(load_at(rows, r, 1, n, j), all(amplitudes[n + j]), pairs);
    }
    V8 reals = all(0);
    for (int j = p.n_pairs; j < p.n_groups; ++j) {
      V8 &to = p.rate[j] != 0 ? reals : pairs;
      to = fused(load_at(rows, r, 0, n, j), all(amplitudes[j]), to);
    }
    f.oscillating[r] = pairs;
    f.decaying[r] = reals;
  }
}

inline void keep(double *ends, const Output8 &f) {
  for (int r = 0; r < 3; ++r) {
    store(ends + 8 * r, f.oscillating[r]);
    store(ends + 24 + 8 * r, f.decaying[r]);
  }
}

inline void recall(const double *ends, Output8 &f) {
  for (int r = 0; r < 3; ++r) {
    f.oscillating[r] = load(ends + 8 * r);
    f.decaying[r] = load(ends + 24 + 8 * r);
  }
}

// Bounds of the sixth derivative and of the rounding of eight forms.
inline void bound_outputs(const PhaseView &p, const OutputsView &o, int block, const double *reach,
                          V8 &sixth, V8 &rounding) {
  const double *m6 = o.sixth + 8 * block * p.n_padded;
  const double *sizes = o.sizes + 8 * block * p.n_padded;
  sixth = all(0);
  V8 size = magnitude(load(o.constants + 8 * block));
  for (int j = 0; j < p.n_groups; ++j) {
    sixth = fused(load(m6 + 8 * j), all(reach[j]), sixth);
    size = fused(load(sizes + 8 * j), all(reach[j]), size);
  }
  rounding = all(output_rounding) * size;
}

// Real exponentials of eight forms between the ends of a piece.
inline void decaying_range(const PhaseView &p, const double *rows, const double *start,
                           const double *end, V8 &low, V8 &high) {
  low = high = all(0);
  for (int j = p.n_pairs; j < p.n_groups; ++j)
    if (p.rate[j] != 0) {
      const V8 c = load_at(rows, 0, 0, p.n_padded, j);
      const V8 a = c * all(start[j]);
      const V8 b = c * all(end[j]);
      low = low + lower(a, b);
      high = high + upper(a, b);
    }
}

inline void include_block(const PhaseView &p, OutputsView &o, int block, const double *start,
                          const double *end, double h, const double *reach, double *scratch) {
  const double *rows = o.rows + 8 * block * 6 * p.n_padded;
  double *ends = o.ends + 48 * block;
  Output8 a;
  Output8 z;
  if (o.continued)
    recall(ends, a);
  else
    sum_output(p, rows, start, a);
  sum_output(p, rows, end, z);
  keep(ends, z);
  const V8 constant = load(o.constants + 8 * block);
  const V8 at_start = constant + a.oscillating[0] + a.decaying[0];
  const V8 at_end = constant + z.oscillating[0] + z.decaying[0];
  const V8 maximum = upper(load(o.maximum + 8 * block), upper(at_start, at_end));
  const V8 minimum = lower(load(o.minimum + 8 * block), lower(at_start, at_end));
  store(o.maximum + 8 * block, maximum);
  store(o.minimum + 8 * block, minimum);
  V8 sixth;
  V8 rounding;
  bound_outputs(p, o, block, reach, sixth, rounding);
  const V8 error = sixth * all(value_error * h * h * h * h * h * h);
  const V8 step = all(h / 5);
  const V8 b1 = fused(step, a.oscillating[1], a.oscillating[0]);
  const V8 b4 = fused_minus(step, z.oscillating[1], z.oscillating[0]);
  const V8 bend = all(h * h / 20);
  const V8 b2 = fused(all(2), b1, fused(bend, a.oscillating[2], all(0) - a.oscillating[0]));
  const V8 b3 = fused(all(2), b4, fused(bend, z.oscillating[2], all(0) - z.oscillating[0]));
  const V8 most =
      upper(upper(upper(a.oscillating[0], z.oscillating[0]), upper(b1, b4)), upper(b2, b3));
  const V8 least =
      lower(lower(lower(a.oscillating[0], z.oscillating[0]), lower(b1, b4)), lower(b2, b3));
  V8 low;
  V8 high;
  decaying_range(p, rows, start, end, low, high);
  unsigned beyond = below(maximum + rounding, constant + most + error + high) |
                    below(constant + least - error + low, minimum - rounding);
  if (beyond == 0)
    return;
  double m6[8];
  double noise[8];
  store(m6, sixth);
  store(noise, rounding);
  for (int i = 0; i < 8; ++i)
    if ((beyond >> i & 1) != 0)
      OutputSearch(p, o, 8 * block + i, start, scratch, m6[i], noise[i]).include(0, h, 0);
}

/// The extremes grow by a piece of length h, in which no magnitude exceeds `reach`.
inline void include_piece(const PhaseView &p, OutputsView &o, const double *start,
                          const double *end, double h, const double *reach, double *scratch) {
  for (int block = 0; block < o.n_blocks; ++block)
    include_block(p, o, block, start, end, h, reach, scratch);
  o.continued = true;
}

} // namespace
} // namespace vibroimpact::motion
