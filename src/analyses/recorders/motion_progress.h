// Tells a line context how far a motion is.
#pragma once

#include "analyses/analysis.h"
#include "motion/interval/observer.h"

namespace vibroimpact::analyses {

/// Watches a window of a motion that is a part of the work at a point, and notes the share that is
/// done from `first` at the window's start to `last` at its end. Lets the motion fly.
class MotionProgress : public motion::Observer {
public:
  MotionProgress(LineContext &context, double start, double end, double first = 0, double last = 1)
      : context_(context), start_(start), end_(end), first_(first), last_(last) {}

  bool sees_steps(const motion::Equations & /*equations*/) const override { return false; }
  void interval(const motion::Interval &interval) override {
    context_.note_progress(first_ + (last_ - first_) * (interval.end() - start_) / (end_ - start_));
  }

private:
  LineContext &context_;
  double start_, end_; ///< [s]
  double first_, last_;
};

} // namespace vibroimpact::analyses
