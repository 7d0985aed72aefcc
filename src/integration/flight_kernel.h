// Flies through one linear phase to the instant at which the first guard falls through zero.
//
// The guards are sums of exponentials f(t). Over a piece of length h each lies within
// h^4 max|f''''| / 384 of the cubic with its values and slopes at both ends, and its slope within
// sqrt(3) h^3 max|f''''| / 216 of that cubic's; the magnitudes of the terms bound the fourth
// derivative. A piece is passed when the cubics' Bernstein coefficients prove all guards positive
// in it. A guard is taken to fall in a piece when its slope is proven negative there, it is
// negative at the end, and all others are proven positive: then it has one zero, which Newton's
// method finds to rounding, from the zero of the cubic. In all other cases the piece is halved.
#pragma once

#include "integration/flight_arithmetic.h"
#include "integration/watched_sums.h"

namespace vibroimpact::integration {

class FlightKernel {
public:
  enum class End {
    limit,  ///< nothing happened
    guard,  ///< guard() is zero here
    unclear ///< nothing can be proven from here on
  };

  /// Guards, and the amplitudes from which the flight goes on. Guards that are zero there must be
  /// told by zero_at_start() next.
  void start(const GuardSums &sums, const Amplitudes &amplitudes);
  double value(std::size_t guard) const { return starts_[guard].value; }
  double slope(std::size_t guard) const { return starts_[guard].slope; }
  /// What rounding may hide of a guard's value.
  double rounding(std::size_t guard) const { return margins_[guard]; }
  /// The guard counts as an exact zero from which it rises.
  void zero_at_start(std::size_t guard);

  /// Every piece flown from now on is shown to `sums`; none: nobody looks.
  void watch(WatchedSums *sums);

  /// Flies for `limit` [s] at most. The time flown is told by flown(), also when nothing could be
  /// proven any more. Throws Interrupted when the run is to stop.
  End fly(double limit);
  double flown() const { return flown_; }
  const Amplitudes &amplitudes() const { return start_; }
  std::size_t guard() const { return falling_; }
  /// |value / slope| left at the zero of guard() [s].
  double residual() const { return residual_; }
  /// Values that the other guards have where guard() is zero.
  double value_at_guard(std::size_t guard) const { return ends_[guard].value; }
  double slope_at_guard(std::size_t guard) const { return ends_[guard].slope; }
  const Amplitudes &amplitudes_at_guard() const { return end_; }
  /// The time from amplitudes() to the zero of guard() [s].
  double time_to_guard() const { return time_to_guard_; }

  long pieces() const { return pieces_; }

private:
  using Value = flight_arithmetic::Height;
  enum class Verdict { positive, falling, unclear };

  void find_factors(double h);
  void move(double h);
  void move_little(double time);
  Value evaluate(std::size_t guard) const;
  void evaluate_all();
  void bound();
  double first_trial(double limit);
  double shortest(double limit) const;
  Verdict judge(double h);
  Verdict judge(std::size_t guard, const flight_arithmetic::Span &span) const;
  void accept(double h);
  bool locate(double h);
  bool is_zero() const;
  bool found(double instant);

  const GuardSums *sums_ = nullptr;
  WatchedSums *watched_ = nullptr;
  std::size_t n_guards_ = 0, n_groups_ = 0;
  Amplitudes start_, end_;
  std::vector<double> factors_, sines_, cosines_; ///< of the exponentials of the groups
  std::vector<Value> starts_, ends_;
  std::vector<double> bounds_, margins_; ///< of the fourth derivatives; of rounding
  std::vector<char> zero_;
  double growth_ = 1;
  double flown_ = 0, time_to_guard_ = 0, residual_ = 0;
  double least_ = 0; ///< shorter pieces do not change the guards near zero
  std::size_t falling_ = 0;
  long pieces_ = 0;
};

} // namespace vibroimpact::integration
