// Tells a line context how far a motion is.
#pragma once

#include "analyses/analysis.h"
#include "motion/interval/observer.h"

namespace vibroimpact::analyses {

/// Watches a window of a motion that is a part of the work at a point, and notes the share that is
/// done from `first` at the window's start to `last` at its end. Lets the motion fly.
class MotionProgress : public motion::Observer, private motion::OutputMonitor {
public:
  MotionProgress(LineContext &context, double start, double end, double first = 0, double last = 1)
      : context_(context), start_(start), end_(end), first_(first), last_(last) {}

  void step(const motion::StepView &view) override { note(view.end()); }
  motion::OutputMonitor *output_monitor() override { return this; }

private:
  void add_forms(const motion::Equations & /*equations*/,
                 std::vector<motion::MonitoredForm> & /*forms*/) override {}
  void part_done(const motion::Equations & /*equations*/, double /*start*/, double end,
                 const Vector & /*state*/) override {
    note(end);
  }
  void note(double time) {
    context_.note_progress(first_ + (last_ - first_) * (time - start_) / (end_ - start_));
  }

  LineContext &context_;
  double start_, end_; ///< [s]
  double first_, last_;
};

} // namespace vibroimpact::analyses
