// Extreme values of linear forms over a part of the motion, eight side by side; included by the
// kernel_*.cc only.
//
// A form f lies within h^6 M / 46080 of the quintic q with its values, slopes and curvatures at
// both ends of a piece, its slope within sqrt(5) h^5 M / 30000 and its curvature within h^4 M /
// 1920 of that quintic's, M being a bound of the sixth derivative. Real exponentials that are fast,
// |e| h > 1, are no part of that: they are monotone, and so are their derivatives, so that they lie
// between their values at the ends. Slow ones must be: one by one they would bound a sum in which
// they cancel no better than to the first order in h. The part is halved until these bounds say
// something. Forms that they leave open are searched: those with one turning point in the piece by
// Newton's and Halley's method, all others by halving the piece.
//
// The work is bounded. A piece is long while some frequency turns by more than about 4 in it, or a
// dense block grows beyond use: a part of length T has some T fastest / 2 such pieces, fewer where
// what is fast has decayed. Where |e| h < 0.02 the quintic is the form but for rounding, and
// another 20 halvings take the second differences of its coefficients, h^2 f'' / 20, below that:
// the search ends there. One that is not long is divided into most_refinements pieces at most,
// which no form without a degenerate extremum asks for; beyond that the values at their ends count.
#pragma once

#include "common/signals.h"
#include "motion/kernel/kernel_turn.h"

namespace vibroimpact::motion {
namespace {

// The largest values of t^3 (1 - t)^3 / 720 and of its first two derivatives on [0, 1], at t = 1/2,
// t (1 - t) = 1/5 and t = 1/2. Of a two-point Hermite interpolant these bound the errors of the
// derivatives too (Birkhoff and Priver 1967).
constexpr double value_error = 1.0 / 46080;
constexpr double middle_error = 1.0 / 14400; // t^3 (1 - t)^3 / 720 is the third of degree six
constexpr double slope_error = 2.23606797749979 / 30000;
constexpr double curvature_error = 1.0 / 1920;
constexpr double output_rounding = 16 * epsilon;
constexpr double no_bound = 1e100; // where that of a dense block overflows
constexpr double fast_decay = 1;   // |e| h of a real exponential
constexpr int most_refinements = 1000;

/// One form from an instant on, whose amplitudes are given.
class TurningPoint {
public:
  /// `rounding`: what rounding may hide of the form.
  TurningPoint(const PhaseView &phase, OutputsView &outputs, int output, const double *start,
               double *scratch, double rounding)
      : p_(phase), o_(outputs), output_(output), start_(start), now_(scratch), rounding_(rounding),
        rows_(outputs.single + output * 8 * phase.n_padded) {}

  /// The extremes grow by the only turning point within h, near t: Halley's method for the slope,
  /// in a bracket. As far from it as d the value lacks f' d + f'' d^2 / 2 + f''' d^3 / 6. `rises`:
  /// the slope at the start is positive.
  void include(double h, double t, bool rises) {
    double lower = 0;
    double upper = h;
    for (int i = 0; i < most_corrections_; ++i) {
      double f[4];
      values(t, f);
      note(f[0]);
      double d = -f[1] / f[2];
      d = d / (1 + 0.5 * d * f[3] / f[2]);
      const double size = d < 0 ? -d : d;
      if (f[1] * f[1] <= rounding_ * (f[2] < 0 ? -f[2] : f[2]))
        return;
      if (size * p_.fastest < 3e-4 && t + d > 0 && t + d < h) {
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

  static constexpr int most_corrections_ = 60;

  const PhaseView &p_;
  OutputsView &o_;
  int output_;
  const double *start_;
  double *now_;
  double rounding_;
  const double *rows_;
};

/// Value, slope and curvature of eight forms at one instant, without their constants: what a
/// quintic follows over a piece, and the fast decays.
struct Output8 {
  V8 smooth[3], fast[3];
};

inline V8 load_at(const double *rows, int r, int part, int n, int j) {
  return load(rows + 8 * ((2 * r + part) * n + j));
}

inline void add_terms(const double *rows, int part, int n, int j, double amplitude, V8 *to) {
  const V8 x = all(amplitude);
  for (int r = 0; r < 3; ++r)
    to[r] = fused(load_at(rows, r, part, n, j), x, to[r]);
}

inline bool is_fast(const PhaseView &p, int j, double h) {
  return __builtin_fabs(p.rate[j]) * h > fast_decay;
}

// Columns of dense blocks, whose rates are zero, stand behind the real exponentials.
inline bool any_fast(const PhaseView &p, double h) {
  for (int j = p.n_pairs; j < p.n_groups; ++j)
    if (is_fast(p, j, h))
      return true;
  return false;
}

inline void sum_output(const PhaseView &p, const double *rows, const double *amplitudes, double h,
                       Output8 &f) {
  const int n = p.n_padded;
  for (int r = 0; r < 3; ++r)
    f.smooth[r] = f.fast[r] = all(0);
  for (int j = 0; j < p.n_pairs; ++j) {
    add_terms(rows, 0, n, j, amplitudes[j], f.smooth);
    add_terms(rows, 1, n, j, amplitudes[n + j], f.smooth);
  }
  for (int j = p.n_pairs; j < p.n_groups; ++j)
    add_terms(rows, 0, n, j, amplitudes[j], is_fast(p, j, h) ? f.fast : f.smooth);
}

// Bounds of the sixth derivative and of the rounding of eight forms.
inline void bound_outputs(const PhaseView &p, const OutputsView &o, int block, const double *reach,
                          double h, V8 &sixth, V8 &size) {
  const double *m6 = o.sixth + 8 * block * p.n_padded;
  const double *sizes = o.sizes + 8 * block * p.n_padded;
  sixth = all(0);
  size = magnitude(load(o.constants + 8 * block));
  for (int j = 0; j < p.n_groups; ++j) {
    const V8 r = all(reach[j]);
    if (j < p.n_pairs || !is_fast(p, j, h))
      sixth = fused(load(m6 + 8 * j), r, sixth);
    size = fused(load(sizes + 8 * j), r, size);
  }
}

// The r-th derivatives of the fast decays of eight forms between the ends of a piece.
inline void fast_range(const PhaseView &p, const double *rows, int r, const double *start,
                       const double *end, double h, V8 &low, V8 &high) {
  low = high = all(0);
  for (int j = p.n_pairs; j < p.n_groups; ++j)
    if (is_fast(p, j, h)) {
      const V8 c = load_at(rows, r, 0, p.n_padded, j);
      const V8 a = c * all(start[j]);
      const V8 b = c * all(end[j]);
      low = low + lower(a, b);
      high = high + upper(a, b);
    }
}

// Bernstein coefficients of the quintic from value, slope and curvature at both ends.
inline void quintic(const V8 *start, const V8 *end, double h, V8 *b) {
  const V8 step = all(h / 5);
  const V8 bend = all(h * h / 20);
  b[0] = start[0];
  b[1] = fused(step, start[1], start[0]);
  b[2] = fused(all(2), b[1], fused(bend, start[2], all(0) - start[0]));
  b[5] = end[0];
  b[4] = fused_minus(step, end[1], end[0]);
  b[3] = fused(all(2), b[4], fused(bend, end[2], all(0) - end[0]));
}

// From degree five to six.
inline void raise_degree(const V8 *b, V8 *c) {
  c[0] = b[0];
  for (int i = 1; i < 6; ++i)
    c[i] = fused(all(i / 6.0), b[i - 1] - b[i], b[i]);
  c[6] = b[5];
}

template <int count> V8 lowest(const V8 *b) {
  V8 least = b[0];
  for (int i = 1; i < count; ++i)
    least = lower(least, b[i]);
  return least;
}

template <int count> V8 highest(const V8 *b) {
  V8 most = b[0];
  for (int i = 1; i < count; ++i)
    most = upper(most, b[i]);
  return most;
}

template <int count> void differences(const V8 *b, V8 *d) {
  for (int i = 0; i < count; ++i)
    d[i] = b[i + 1] - b[i];
}

// sqrt(x^2 + y^2) <= max + min / 2, since max min >= 3/4 min^2.
inline V8 modulus_bound(V8 x, V8 y) {
  const V8 a = magnitude(x);
  const V8 b = magnitude(y);
  return fused(all(0.5), lower(a, b), upper(a, b));
}

// Bound of the magnitudes between two instants, h apart. The modulus of an exponential is largest
// at one of them.
inline void bound_reach(const PhaseView &p, const OutputsView &o, const double *start,
                        const double *end, double h, double *reach) {
  const int n = p.n_padded;
  for (int b = 0; b < n; b += group_block) {
    const V8 at_start = modulus_bound(load(start + b), load(start + n + b));
    const V8 at_end = modulus_bound(load(end + b), load(end + n + b));
    store(reach + b, upper(at_start, at_end));
  }
  const double *generator = o.dense_magnitudes;
  for (int d = 0; d < p.n_dense; ++d) {
    const int first = p.dense[d].first;
    const int size = p.dense[d].size;
    for (int i = first; i < first + size; ++i)
      reach[i] = __builtin_fabs(start[i]);
    turn_dense_block(generator, size, h, reach + first, reach + first);
    for (int i = first; i < first + size; ++i)
      reach[i] = reach[i] < no_bound ? reach[i] : no_bound;
    generator += size * size;
  }
}

/// Eight forms over a part of the motion.
class BlockSearch {
public:
  BlockSearch(const PhaseView &phase, OutputsView &outputs, int block)
      : p_(phase), o_(outputs), block_(block), rows_(outputs.rows + 48 * block * phase.n_padded) {}

  void include(const double *start, const double *end, double h) {
    include(end_of(start, h), end_of(end, h), h, 0xff, 0);
  }

private:
  struct End {
    const double *amplitudes;
    Output8 values;
  };

  // Of a piece of length h.
  End end_of(const double *amplitudes, double h) const {
    End end;
    end.amplitudes = amplitudes;
    sum_output(p_, rows_, amplitudes, h, end.values);
    return end;
  }

  // Of the forms `which`.
  void include(const End &start, const End &end, double h, unsigned which, int halvings) {
    a_ = &start;
    z_ = &end;
    h_ = h;
    ++o_.pieces;
    include_ends();
    if (is_long() && !refining_ && halvings < most_halvings) {
      halve(start, end, h, which, halvings);
      return;
    }
    unsigned open = which & beyond();
    open = open != 0 ? open & ~monotone() : 0;
    if (open == 0)
      return;
    const unsigned bends = bending();
    if (const unsigned turning = open & bends & turns(); turning != 0)
      include_turns(turning);
    if ((open & ~bends) != 0 && halvings < most_halvings)
      refine(start, end, h, open & ~bends, halvings);
  }

  // Is the quintic too far from some form to say anything?
  bool is_long() {
    constexpr double tolerated = 1e-1;
    bound_reach(p_, o_, a_->amplitudes, z_->amplitudes, h_, o_.reach);
    V8 size;
    bound_outputs(p_, o_, block_, o_.reach, h_, sixth_, size);
    rounding_ = all(output_rounding) * size;
    const double h2 = h_ * h_;
    sixth_ = sixth_ * all(h2 * h2 * h2);
    return below(all(tolerated / value_error) * size, sixth_) != 0;
  }

  // Of a piece that is not long.
  void refine(const End &start, const End &end, double h, unsigned which, int halvings) {
    const bool first = !refining_;
    if (first)
      refinements_ = most_refinements;
    refining_ = true;
    if (refinements_-- > 0)
      halve(start, end, h, which, halvings);
    refining_ = !first;
  }

  // What is fast in a piece may be slow in its halves.
  void halve(const End &start, const End &end, double h, unsigned which, int halvings) {
    leave_if_stopped();
    if (!any_fast(p_, h)) {
      halve_at(start, end, 0.5 * h, which, halvings);
      return;
    }
    halve_at(end_of(start.amplitudes, 0.5 * h), end_of(end.amplitudes, 0.5 * h), 0.5 * h, which,
             halvings);
  }

  void halve_at(const End &start, const End &end, double half, unsigned which, int halvings) {
    double *middle = o_.middles + 2 * p_.n_padded * halvings;
    turn(p_, start.amplitudes, half, middle);
    const End between = end_of(middle, half);
    include(start, between, half, which, halvings + 1);
    include(between, end, half, which, halvings + 1);
  }

  void include_ends() {
    double *maximum = o_.maximum + 8 * block_;
    double *minimum = o_.minimum + 8 * block_;
    const V8 constant = load(o_.constants + 8 * block_);
    const V8 at_start = constant + a_->values.smooth[0] + a_->values.fast[0];
    const V8 at_end = constant + z_->values.smooth[0] + z_->values.fast[0];
    store(maximum, upper(load(maximum), upper(at_start, at_end)));
    store(minimum, lower(load(minimum), lower(at_start, at_end)));
  }

  // Forms that may exceed the extremes so far. In degree six the error of the quintic stands at the
  // middle coefficient alone, |f - p| <= h^6 M / 6! tau^3 (1 - tau)^3 = h^6 M / (20 6!) B_3(tau).
  unsigned beyond() {
    quintic(a_->values.smooth, z_->values.smooth, h_, b_);
    V8 c[7], low, high;
    raise_degree(b_, c);
    fast_range(p_, rows_, 0, a_->amplitudes, z_->amplitudes, h_, low, high);
    const V8 constant = load(o_.constants + 8 * block_);
    const V8 error = sixth_ * all(middle_error);
    const V8 most = upper(highest<7>(c), c[3] + error);
    const V8 least = lower(lowest<7>(c), c[3] - error);
    return below(load(o_.maximum + 8 * block_) + rounding_, constant + most + high) |
           below(constant + least + low, load(o_.minimum + 8 * block_) - rounding_);
  }

  // Forms whose slope, times h, has one sign.
  unsigned monotone() {
    differences<5>(b_, slope_);
    return one_sign(1, all(5) * lowest<5>(slope_), all(5) * highest<5>(slope_), slope_error);
  }

  // Forms whose curvature, times h^2, has one sign.
  unsigned bending() {
    V8 bend[4];
    differences<4>(slope_, bend);
    return one_sign(2, all(20) * lowest<4>(bend), all(20) * highest<4>(bend), curvature_error);
  }

  unsigned one_sign(int r, V8 least, V8 most, double bound) const {
    V8 low;
    V8 high;
    fast_range(p_, rows_, r, a_->amplitudes, z_->amplitudes, h_, low, high);
    const V8 unit = all(r == 1 ? h_ : h_ * h_);
    const V8 error = sixth_ * all(bound);
    return below(all(0), fused(low, unit, least - error)) |
           below(fused(high, unit, most + error), all(0));
  }

  // Forms whose slope differs in sign at the ends, of one sign of the curvature. Where a slope is
  // next to zero, the end is exceeded by |slope| h at most.
  unsigned turns() const {
    const V8 s = a_->values.smooth[1] + a_->values.fast[1];
    const V8 t = z_->values.smooth[1] + z_->values.fast[1];
    return (below(all(0), s) ^ below(all(0), t)) &
           below(rounding_, lower(magnitude(s), magnitude(t)) * all(h_));
  }

  // The zero of the slope of the quintic through both ends, decays and all, by Newton's method from
  // where its chord is zero: as near as makes one exact evaluation enough.
  V8 turning_points() const {
    V8 start[3];
    V8 end[3];
    for (int r = 0; r < 3; ++r) {
      start[r] = a_->values.smooth[r] + a_->values.fast[r];
      end[r] = z_->values.smooth[r] + z_->values.fast[r];
    }
    V8 b[6];
    V8 d[5];
    quintic(start, end, h_, b);
    differences<5>(b, d);
    V8 c[5]; // powers
    c[0] = d[0];
    c[1] = all(4) * (d[1] - d[0]);
    c[2] = all(6) * (d[2] - all(2) * d[1] + d[0]);
    c[3] = all(4) * (d[3] - d[0] + all(3) * (d[1] - d[2]));
    c[4] = d[0] + d[4] - all(4) * (d[1] + d[3]) + all(6) * d[2];
    V8 x = start[1] / (start[1] - end[1]);
    for (int i = 0; i < 3; ++i) {
      const V8 f = fused(x, fused(x, fused(x, fused(x, c[4], c[3]), c[2]), c[1]), c[0]);
      const V8 g = fused(x, fused(x, fused(x, all(4) * c[4], all(3) * c[3]), all(2) * c[2]), c[1]);
      x = lower(upper(x - f / g, all(0)), all(1));
    }
    return x;
  }

  void include_turns(unsigned which) {
    double x[8];
    double slope[8];
    double noise[8];
    store(x, turning_points());
    store(slope, a_->values.smooth[1] + a_->values.fast[1]);
    store(noise, rounding_);
    for (; which != 0; which &= which - 1) {
      const int i = __builtin_ctz(which);
      TurningPoint(p_, o_, 8 * block_ + i, a_->amplitudes, o_.turned, noise[i])
          .include(h_, x[i] * h_, slope[i] > 0);
    }
  }

  const PhaseView &p_;
  OutputsView &o_;
  int block_;
  const double *rows_;
  // Of the present piece:
  const End *a_ = nullptr, *z_ = nullptr;
  double h_ = 0;
  V8 sixth_, rounding_;   ///< h^6 M, and what rounding may hide
  V8 b_[6], slope_[5];    ///< of what is smooth
  bool refining_ = false; ///< a piece that was not long
  int refinements_ = 0;   ///< that it may still be divided by
};

/// The extremes grow by a part of length h.
inline void include_part(const PhaseView &p, OutputsView &o, const double *start, const double *end,
                         double h) {
  for (int block = 0; block < o.n_blocks; ++block)
    BlockSearch(p, o, block).include(start, end, h);
}

} // namespace
} // namespace vibroimpact::motion
