// Extreme values of one linear form over a piece; included by the kernel_*.cc only.
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
        include_turn(from, to, from + h * s0 / (s0 - s1), s0 > 0);
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

  // The only turning point between `from` and `to`, near t: Halley's method for the slope, in a
  // bracket. As far from it as d the value lacks f' d + f'' d^2 / 2 + f''' d^3 / 6.
  void include_turn(double from, double to, double t, bool rises) {
    double lower = from;
    double upper = to;
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

} // namespace
} // namespace vibroimpact::motion
