// Equally spaced samples of chosen signals, from the dense output: the steps are not disturbed.
#pragma once

#include "analyses/observed_signal.h"

#include <vector>

namespace vibroimpact::analyses {

class UniformSamples {
public:
  /// Samples at start + i * interval, i = 0 ... count - 1. NumericalError when there is no memory
  /// for them.
  UniformSamples(std::vector<ObservedSignal> signals, double start, double interval,
                 std::size_t count);

  /// The next step. A sample at a contact change is taken before it.
  void step(const motion::StepView &view);

  const std::vector<ObservedSignal> &signals() const { return signals_; }
  double interval() const { return interval_; }
  /// Samples of a signal taken so far.
  const std::vector<double> &values(std::size_t signal) const { return values_[signal]; }

private:
  std::vector<ObservedSignal> signals_;
  double start_, interval_;
  std::size_t count_, next_ = 0;
  std::vector<std::vector<double>> values_;
};

} // namespace vibroimpact::analyses
