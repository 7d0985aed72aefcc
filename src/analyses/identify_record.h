// The force of one contact as a transducer with a fixed sampling frequency sees it.
#pragma once

#include "analyses/identify_formulas.h"
#include "motion/event/impact_log.h"

#include <vector>

namespace vibroimpact::analyses {

/// Samples the normal force at 0, T, 2 T, ... from the dense output; the steps are not disturbed.
class ForceRecord : public motion::Observer {
public:
  /// interval T [s]
  ForceRecord(std::size_t contact, double interval) : contact_(contact), interval_(interval) {}

  void step(const motion::StepView &view) override;

  const std::vector<double> &time() const { return time_; }   ///< [s]
  const std::vector<double> &force() const { return force_; } ///< [N]

  /// Largest sample and sum of samples times T (the trapezoidal rule, as the force is zero at both
  /// ends) while the impact lasts. Both are zero when no sample falls into it.
  PulseFigures figures(const motion::Impact &impact) const;

private:
  std::size_t contact_;
  double interval_;
  std::vector<double> time_, force_;
};

} // namespace vibroimpact::analyses
