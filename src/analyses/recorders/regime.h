// The regime (kT, n, m) of a motion: after how many forcing periods it repeats and how often each
// contact is hit in that time; where it does not repeat, whether it is still settling,
// quasi-periodic or chaotic.
//
// Over the part of the window that counts, from the share d of it to its end, deviations that grow
// like t^p, as those of free bodies do, grow by the factor d^-p only: more than that of p = 2 is
// exponential growth. A motion is called quasi-periodic or chaotic only where the exponent has a
// standard error.
#pragma once

#include "analyses/recorders/lyapunov.h"
#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"
#include "analyses/signals/repetition.h"

#include <map>
#include <optional>

namespace vibroimpact::analyses {

enum class Regime : int {
  aperiodic = 0,      ///< does not repeat; no exponent was computed
  periodic = 1,       ///< repeats after period_multiple forcing periods
  settling = 2,       ///< still approaches a motion that repeats
  quasi_periodic = 3, ///< does not repeat, deviations neither grow nor shrink
  chaotic = 4,        ///< deviations grow exponentially
  undecided = 5       ///< does not repeat; the window is too short to tell 3 from 4
};

struct RegimeSettings {
  long longest = 16;                ///< [periods]
  double tolerance = 1e-7;          ///< of the repetition, relative to the scales
  std::vector<double> scales{};     ///< [SI] of the states; empty: from the motion
  bool exponent = true;             ///< carry the variational equation along
  double exponent_threshold = 0.02; ///< per forcing period
};

class RegimeRecorder : public Recorder {
public:
  /// The system must outlive it.
  RegimeRecorder(const System &system, RegimeSettings settings);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  void event(const motion::ContactEvent &event) override;
  void period_end(long cycle, const motion::Trajectory &trajectory) override;
  void add_fields(const FieldWriter &result) const override;

private:
  Vector scales() const;
  StroboscopicPoints points() const;
  Regime classify(const Repetition &repetition, const Approach &approach) const;
  double counted_periods() const;
  bool grows_exponentially(double growth) const;
  double deciding_cycles() const;
  void add_impacts(const FieldWriter &result, long multiple) const;

  const System &system_;
  RegimeSettings settings_;
  double period_ = 0;
  motion::StateLayout layout_;
  Vector reach_;               ///< makes coordinates of different bodies comparable
  Vector smallest_, largest_;  ///< of the physical state over the window
  std::vector<Vector> states_; ///< at the period ends, the window's start included
  std::vector<long> impacts_;  ///< begun in the window, per contact
  std::optional<LyapunovExponents> exponents_;
};

} // namespace vibroimpact::analyses
