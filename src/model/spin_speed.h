// The speed at which bodies turn: constant, or between two constant speeds a ramp in time.
#pragma once

namespace vibroimpact::model {

class SpinSpeed {
public:
  explicit SpinSpeed(double speed) : first_(speed), last_(speed) {}
  /// From `first` to `last` [rad/s] between `start` and `start` + `duration` > 0 [s].
  SpinSpeed(double first, double last, double start, double duration)
      : first_(first), last_(last), start_(start), duration_(duration) {}

  bool constant() const { return first_ == last_; }
  double at(double time) const; ///< [rad/s]
  /// Its derivative [rad/s^2]; at both ends of the ramp from the right.
  double rate(double time) const;
  /// Its integral from time zero [rad].
  double angle(double time) const;
  double highest() const; ///< of its absolute values [rad/s]
  /// First instant > time at which the rate changes; +infinity when there is none.
  double next_break(double time) const;

private:
  double end() const { return start_ + duration_; }
  double integral(double time) const; ///< from the start

  double first_ = 0;
  double last_ = 0;
  double start_ = 0;
  double duration_ = 0;
};

} // namespace vibroimpact::model
