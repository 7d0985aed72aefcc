// The guards of a linear phase as functions of time, seen exactly, and the proof of where the first
// of them falls through zero.
//
// On [a, b] a smooth function f lies within
//
//   p(t) +- M (b - a)^6 / 14400 B(t),      B = the middle Bernstein polynomial of degree six
//
// p being the quintic with its values, slopes and curvatures at a and b, and M a bound of |f^(6)|
// there, because f - p = f^(6)(xi) / 720 (t - a)^3 (t - b)^3. Intervals are halved until these two
// polynomials show that f has no zero, exactly one, or is below the rounding of its own evaluation.
#pragma once

#include "common/linear_algebra.h"

#include <optional>

namespace vibroimpact::motion {

/// Value and derivatives of a function at an instant.
struct Jet {
  double value = 0, rate = 0, acceleration = 0;
};

/// Functions of the time since the start of a step.
class GuardCurves {
public:
  virtual ~GuardCurves() = default;

  virtual Index size() const = 0;
  virtual Jet at(Index guard, double time) const = 0;
  /// Bound of the sixth derivative between two instants.
  virtual double sixth_derivative(Index guard, double from, double to) const = 0;
  /// What rounding may hide of a value within the step.
  virtual double rounding(Index guard) const = 0;
};

/// What is known of a guard at the start of a step.
struct GuardStart {
  /// It was zero when its mode began, as far as that instant could be located: leaving that zero is
  /// no touch.
  bool zero = false;
  double shift = 0; ///< added to all its values
  /// Before this time it counts as zero: that instant is not known better, and where it leaves zero
  /// with neither slope nor curvature, errors of theirs would be taken for a fall.
  double until = 0;
};

struct FirstDownCrossing {
  std::optional<double> time{}; ///< of the first fall through zero
  /// First instant at which the guard came within its rounding of zero and rose again, before any
  /// fall: whether it passed zero there is undecided, and it counts as not passed.
  std::optional<double> touch{};
};

/// The first fall of a guard from 0 to `end`. A guard that is below zero at 0 falls there.
FirstDownCrossing first_down_crossing(const GuardCurves &curves, Index guard, double end,
                                      const GuardStart &start = {});

} // namespace vibroimpact::motion
