// Extreme values of linear forms of the motion in a phase.
#pragma once

#include "motion/exact/exact_phase.h"
#include "motion/segment/output_monitor.h"

#include <vector>

namespace vibroimpact::motion {

class ExactOutputs {
public:
  /// Keeps references to both.
  ExactOutputs(const MonitoredForms &forms, const ExactPhase &phase);

  /// The inputs of the phase are others.
  void renew();

  /// The extremes known so far, which those of the next part of the motion are to exceed.
  OutputsView &begin();
  /// That part is over: the ranges have grown by it.
  void end();

private:
  void arrange();
  void set_group(const PhaseGroup &group);
  void set_pair(std::size_t form, const PhaseGroup &group);
  void set_dense(std::size_t form, const PhaseGroup &group);
  double seen(std::size_t form, Index coordinate) const;
  void store(std::size_t form, std::size_t j, Index order, double real, double imaginary);

  const MonitoredForms &forms_;
  const ExactPhase &phase_;
  long arrangement_ = -1, generation_ = -1;
  AlignedArray constants_, rows_, sixth_, sizes_, single_, minimum_, maximum_, ends_, middles_;
  OutputsView view_;
};

} // namespace vibroimpact::motion
