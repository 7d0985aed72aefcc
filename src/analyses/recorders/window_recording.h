// Watches a window of a motion with the recorders of an analysis.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"

#include <functional>
#include <memory>
#include <vector>

namespace vibroimpact::analyses {

/// Serves any number of windows of motions of one system, one after the other.
class WindowRecording {
public:
  /// Makes a set of recorders; the system must outlive them. InputError when options do not fit
  /// the system.
  WindowRecording(const std::vector<RecorderFactory> &factories, const System &system);

  /// Integrates from window.start, where the trajectory must stand, to window.end, stopping at the
  /// end of each period; `after_period`, where given, is called there. `also` watches as well.
  /// NumericalError.
  void run(const Window &window, motion::Trajectory &trajectory,
           const std::function<void(long period)> &after_period = {});
  void run(const Window &window, motion::Trajectory &trajectory,
           const std::vector<motion::Observer *> &also);

  bool empty() const { return recorders_.empty(); }
  /// Before the first window: leaves those recorders alone that have derivatives of their own.
  void keep_extrema();
  std::vector<ObservedExtremum> extrema() const;
  void add_tangents(const TangentMotion &motion, const FieldWriter &result) const;

  /// What all recorders saw.
  void add_fields(const FieldWriter &result) const;

private:
  /// These, then the recorders.
  motion::Observers observers(std::vector<motion::Observer *> list) const;
  void watch(const Window &window, motion::Trajectory &trajectory, const motion::Observers &all,
             const std::function<void(long period)> &after_period);

  std::vector<std::unique_ptr<Recorder>> recorders_;
  motion::Observers together_{
      std::vector<motion::Observer *>()}; ///< the same for all windows, so that it is asked once
};

/// A window of `cycles` periods that begins at `start`.
Window periods_window(double start, double period, long cycles);

} // namespace vibroimpact::analyses
