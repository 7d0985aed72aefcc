// The turning point of one linear form in a piece; included by the kernel_*.cc only.
#pragma once

#include "motion/exact/kernel_turn.h"

namespace vibroimpact::motion {
namespace {

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

} // namespace
} // namespace vibroimpact::motion
