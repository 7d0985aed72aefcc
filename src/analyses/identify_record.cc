#include "analyses/identify_record.h"

#include <algorithm>

namespace vibroimpact::analyses {

void ForceRecord::step(const motion::StepView &view) {
  const auto next = [this] { return interval_ * static_cast<double>(time_.size()); };
  while (next() <= view.end()) {
    time_.push_back(next());
    force_.push_back(view.force(contact_, (time_.back() - view.start()) / view.length()));
  }
}

PulseFigures ForceRecord::figures(const motion::Impact &impact) const {
  const auto first = std::lower_bound(time_.begin(), time_.end(), impact.start_time);
  const auto last = std::upper_bound(first, time_.end(), impact.start_time + impact.duration);
  PulseFigures figures;
  for (auto i = first - time_.begin(); i < last - time_.begin(); ++i) {
    const double force = force_[static_cast<std::size_t>(i)];
    figures.impulse += force * interval_;
    figures.peak_force = std::max(figures.peak_force, force);
  }
  return figures;
}

} // namespace vibroimpact::analyses
