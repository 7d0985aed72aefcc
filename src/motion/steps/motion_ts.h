// A motion as one of PETSc's time integrators, for who wants to look at it with PETSc's means:
// -ts_monitor, -ts_monitor_solution, -ts_view. Its type is "motion"; each of its steps is the
// motion from one instant that an analysis asks for to the next, a period's end for instance,
// through any number of phases and contact changes on the way. The stock integrators that take
// steps within a phase carry the prefix sub_ (-sub_ts_type, -sub_ts_monitor).
//
// It is made only where an option asks for it, so that motions pay nothing for it otherwise.
#pragma once

#include "common/linear_algebra.h"
#include "motion/settings.h"

#include <functional>
#include <memory>

namespace vibroimpact::motion {

class MotionTs {
public:
  /// nullptr where no option of PETSc begins with -ts_. `size`: of the state. InputError for
  /// another -ts_type.
  static std::unique_ptr<MotionTs> create(const Settings &settings, Index size);
  ~MotionTs();
  MotionTs(const MotionTs &) = delete;
  MotionTs &operator=(const MotionTs &) = delete;

  /// The motion stands at `start` with `state`; `advance` takes it to `end` and returns its state
  /// there. What it throws comes out of this.
  void step(double start, const Vector &state, double end,
            const std::function<const Vector &()> &advance);

private:
  struct Data;
  MotionTs(const Settings &settings, Index size);

  std::unique_ptr<Data> data_;
};

} // namespace vibroimpact::motion
