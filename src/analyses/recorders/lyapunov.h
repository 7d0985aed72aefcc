// The largest Lyapunov exponents of the recorded motion, by the variational equation through the
// contacts (Benettin et al. 1980; Mueller 1995 for the jumps).
//
// The deviations d_1 ... d_n are made orthonormal again after every step and event, D = Q R.
// Volumes of the first k grow by R_11 ... R_kk, so that the k-th exponent is the mean of ln R_kk
// per time. The sum of all exponents is the mean divergence of the motion, (int tr J dt + sum ln
// |det D_e|) / T with the saltation matrices D_e of its events.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"
#include "analyses/signals/growth.h"
#include "motion/variation/variation.h"

#include <memory>
#include <optional>
#include <vector>

namespace vibroimpact::analyses {

struct LyapunovSettings {
  long exponents = 1;           ///< 0: one for each physical state
  double discarded_share = 0.1; ///< of the window, for the deviations to turn
  long blocks = 10;             ///< of the standard error
  double tolerance = 1e-8;      ///< of the variation, per step
};

/// The exponents themselves, for recorders that need them.
class LyapunovExponents : public motion::Observer {
public:
  explicit LyapunovExponents(const LyapunovSettings &settings) : settings_(settings) {}

  /// The trajectory stands at the window's start. Periods end exactly when period_end() is called;
  /// a window without periods is divided into about 200 intervals that end with a step.
  void begin(const Window &window, const motion::Trajectory &trajectory);
  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override;
  void period_end(double time) { end_interval(time); }

  /// Of the largest exponent.
  const Growth &growth() const { return growths_.front(); }
  /// In falling order up to their errors, as many as asked for [1/s]. -infinity: deviations end in
  /// an event, such as those of the internal state of a bumper when it is touched.
  std::vector<double> exponents() const;
  std::vector<double> standard_errors() const;
  double mean_divergence() const { return divergence_.exponent(); } ///< [1/s]
  long tangential_events() const { return variation_ ? variation_->tangential_events() : 0; }

private:
  void end_interval(double time);

  LyapunovSettings settings_;
  std::vector<Growth> growths_{Growth(settings_.discarded_share)};
  Growth divergence_{settings_.discarded_share}; ///< of the volume of all deviations
  std::optional<motion::Variation> variation_;
  Vector logarithms_;      ///< of the growths since the interval began
  double determinant_ = 0; ///< its logarithm where the interval began
  double interval_start_ = 0;
  double interval_ = 0; ///< [s]; 0 where the window has periods
};

class LyapunovRecorder : public Recorder {
public:
  explicit LyapunovRecorder(const LyapunovSettings &settings) : exponents_(settings) {}

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override { exponents_.step(view); }
  void event(const motion::ContactEvent &event) override { exponents_.event(event); }
  void period_end(long cycle, const motion::Trajectory &trajectory) override;
  void add_fields(const FieldWriter &result) const override;

private:
  LyapunovExponents exponents_;
  double period_ = 0;
  bool all_ = false; ///< as many exponents as states
};

} // namespace vibroimpact::analyses
