// Between which instants a motion is smooth.
#pragma once

#include "motion/interval/observer.h"

#include <vector>

namespace vibroimpact::analyses {

/// From one event or break of the sources to the next.
struct SmoothInterval {
  double start = 0, end = 0; ///< [s]
  std::vector<int> modes{};  ///< of all contacts
  bool from_break = false;   ///< of the sources, without an event
  long steps = 0;
};

class SmoothIntervals : public motion::Observer {
public:
  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override { events.push_back(event.time); }

  std::vector<double> events; ///< their instants, in their order [s]
  std::vector<SmoothInterval> list;
  bool breaks = false; ///< of the sources were passed

private:
  double next_break_ = 0; ///< of the sources, in the present interval [s]
};

} // namespace vibroimpact::analyses
