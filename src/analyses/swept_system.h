// The system of a stepped sweep at the present value of the swept parameter.
#pragma once

#include "analyses/analysis.h"
#include "analyses/settling.h"
#include "analyses/swept_parameter.h"
#include "analyses/window_recording.h"
#include "motion/trajectory.h"

#include <memory>
#include <optional>

namespace vibroimpact::analyses {

/// Index of the excitation that gives an analysis its period: `name`, or the only one that repeats
/// when the name is empty. InputError when there is none, or one without a frequency. `who` needs
/// it: "A stepped sweep".
std::size_t sweep_source(const System &system, const std::string &name,
                         const std::string &who = "A stepped sweep");

class SweptSystem {
public:
  /// Keeps references. A frequency is set in `system` itself; for another key the systems are built
  /// by `context`.
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
  void build(double value);

  const SweptParameter &parameter_;
  std::string excitation_;
  const std::vector<RecorderFactory> &recorders_;
  System &original_;
  const LineContext &context_;
  std::unique_ptr<System> built_;
  const System *present_;
  std::unique_ptr<motion::Trajectory> trajectory_;
  std::optional<Settler> settler_;
  std::optional<WindowRecording> recording_; ///< once asked for
  Index size_ = 0;
  double period_ = 0;
};

} // namespace vibroimpact::analyses
