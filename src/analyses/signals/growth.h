// Mean exponential growth of a deviation, with its statistical error, from the growth over
// consecutive intervals.
#pragma once

#include <cstddef>
#include <vector>

namespace vibroimpact::analyses {

class Growth {
public:
  /// The share of the total time at the start during which the deviation only turns into the
  /// direction that grows most.
  explicit Growth(double discarded_share) : discarded_share_(discarded_share) {}

  /// ln(size after / size before) of an interval of the given duration [s].
  void add(double duration, double logarithm);

  std::size_t intervals() const { return logarithms_.size(); }
  /// Mean of the growth [1/s] after the discarded share; NaN without an interval.
  double exponent() const;
  /// Mean over the intervals after the discarded share up to each of them [1/s].
  std::vector<double> running_exponent() const;
  /// Ends of the intervals that running_exponent() counts, from the beginning of all [s].
  std::vector<double> elapsed() const;
  /// Standard error of exponent() from the scatter of the means of `blocks` >= 2 equal blocks; NaN
  /// when there are fewer than two intervals per block. The blocks must be longer than the memory
  /// of the motion.
  double standard_error(std::size_t blocks) const;

private:
  std::size_t first() const;

  double discarded_share_;
  std::vector<double> durations_, logarithms_;
};

} // namespace vibroimpact::analyses
