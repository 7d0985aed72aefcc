// How long a step may be for the sources that move gaps, and for those that act on sides that
// stick.
//
// Gaps are polynomials within a step, made of values, rates and accelerations at its ends. Error
// control sees coordinates only; where a base moves the gap of a body that is held, no coordinate
// tells how fast. The sources are known, so that the error of their polynomial is: in the middle of
// the step, where (t - a)^3 (b - t)^3 is largest. Where sides stick, nothing moves that would tell
// how fast the force changes that holds them; there the polynomial of every source counts, against
// the source itself.
#pragma once

#include "model/exponential_form.h"
#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

class SourceStep {
public:
  /// Keeps a reference. relative: tolerance of the sources while sides stick.
  SourceStep(const Equations &equations, double relative);

  /// `length`, or less where the polynomials would miss the sources by more than the tolerances
  /// [m, one per source] in a step of that length from `time` on; both in s.
  double limited(double time, double length, const Vector &tolerances) const;

private:
  /// Error over tolerance, the largest of all sources.
  double error(double time, double length, const Vector &tolerances) const;

  bool sticks() const;

  const Equations &equations_;
  double relative_;
  std::vector<std::size_t> moving_; ///< the sources that move a gap, or may act on sides that stick
};

/// Third derivative of a source, of its unit per s^3.
double third_derivative(const model::ExponentialForm &form, double time);

} // namespace vibroimpact::motion
