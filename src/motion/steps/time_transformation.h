// How time goes on in a step, as a function of the step's own variable from 0 to 1: evenly, or as
// the root of the time since or until an instant does.
#pragma once

namespace vibroimpact::motion {

/// Times in s. Where span is not zero, time = origin + sign (root + s span)^2.
struct TimeTransformation {
  double start = 0, length = 0;
  double origin = 0, sign = 1, root = 0, span = 0;

  static TimeTransformation even(double start, double end);
  /// Evenly in the root of the time since `instant`, which is `start` or before it.
  static TimeTransformation since(double instant, double start, double end);
  /// Evenly in the root of the time until `instant`, which is `end` or after it.
  static TimeTransformation until(double instant, double start, double end);
  /// The same to another end; where that is beyond the instant, until that end.
  TimeTransformation to(double end) const;

  double time(double s) const {
    const double r = root + s * span;
    return span == 0 ? start + s * length : origin + sign * r * r;
  }
  /// d time / ds
  double rate(double s) const { return span == 0 ? length : 2 * sign * span * (root + s * span); }
};

} // namespace vibroimpact::motion
