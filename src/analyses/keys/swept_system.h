// The system of a stepped sweep at the present value of the swept parameter.
#pragma once

#include "analyses/keys/keyed_system.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/sweeps/settling.h"
#include "motion/path/trajectory.h"

#include <memory>
#include <optional>

namespace vibroimpact::analyses {

class SweptSystem {
public:
  /// As for KeyedSystem.
  SweptSystem(const SweptParameter &parameter, const std::string &excitation,
              const std::vector<RecorderFactory> &recorders, System &system,
              const LineContext &context);

  /// InputError when the system cannot be built or has other coordinates than before.
  void move_to(double value);

  const System &system() const { return *present_; }
  motion::Trajectory &trajectory() { return *trajectory_; }
  /// Settles motions of that trajectory.
  Settler &settler() { return *settler_; }
  /// The recorders of the analysis for the present system.
  WindowRecording &recording();
  double period() const { return period_; } ///< [s]
  /// Scale of the states, see state_scale().
  Vector scale() const;

private:
  void renew();

  KeyedSystem keyed_;
  const std::vector<RecorderFactory> &recorders_;
  std::shared_ptr<const System> present_;
  std::unique_ptr<motion::Trajectory> trajectory_;
  std::optional<Settler> settler_;
  std::optional<WindowRecording> recording_; ///< once asked for
  Index size_ = 0;
  double period_ = 0;
};

} // namespace vibroimpact::analyses
