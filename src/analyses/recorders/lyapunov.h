// Largest Lyapunov exponent of the recorded motion, by the variational equation through the
// contacts (Benettin et al. 1980; Mueller 1995 for the jumps).
#pragma once

#include "analyses/character/growth.h"
#include "analyses/recorder.h"
#include "motion/variation/variation.h"

#include <memory>
#include <optional>

namespace vibroimpact::analyses {

struct LyapunovSettings {
  double discarded_share = 0.1; ///< of the window, for the deviation to turn
  long blocks = 10;             ///< of the standard error
  double tolerance = 1e-8;      ///< of the variation, per step
};

/// The exponent itself, for recorders that need it.
class LyapunovExponent : public motion::Observer {
public:
  explicit LyapunovExponent(const LyapunovSettings &settings)
      : settings_(settings), growth_(settings.discarded_share) {}

  /// The trajectory stands at the window's start. Periods end exactly when period_end() is called;
  /// a window without periods is divided into about 200 intervals that end with a step.
  void begin(const Window &window, const motion::Trajectory &trajectory);
  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override { variation_->event(event); }
  void period_end(double time);

  const Growth &growth() const { return growth_; }
  /// exponent(), standard error [1/s]
  double exponent() const { return growth_.exponent(); }
  double standard_error() const {
    return growth_.standard_error(static_cast<std::size_t>(settings_.blocks));
  }
  long tangential_events() const { return variation_ ? variation_->tangential_events() : 0; }

private:
  void end_interval(double time);

  LyapunovSettings settings_;
  Growth growth_;
  std::optional<motion::Variation> variation_;
  double interval_start_ = 0;
  double interval_ = 0; ///< [s]; 0 where the window has periods
};

class LyapunovRecorder : public Recorder {
public:
  explicit LyapunovRecorder(const LyapunovSettings &settings) : exponent_(settings) {}

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override { exponent_.step(view); }
  void event(const motion::ContactEvent &event) override { exponent_.event(event); }
  void period_end(long cycle, const motion::Trajectory &trajectory) override;
  void add_fields(PointResult &result) const override;

private:
  LyapunovExponent exponent_;
  double period_ = 0;
};

} // namespace vibroimpact::analyses
