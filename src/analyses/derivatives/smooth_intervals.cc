#include "analyses/derivatives/smooth_intervals.h"

namespace vibroimpact::analyses {

void SmoothIntervals::step(const motion::StepView &view) {
  const double next_break = view.equations().source_break();
  const bool from_break = !list.empty() && next_break != next_break_;
  const bool from_event = list.empty() || (!events.empty() && events.back() >= list.back().end);
  next_break_ = next_break;
  breaks = breaks || from_break;
  if (from_break || from_event)
    list.push_back(
        {.start = view.start(), .modes = view.equations().modes(), .from_break = !from_event});
  list.back().end = view.end();
  ++list.back().steps;
}

} // namespace vibroimpact::analyses
