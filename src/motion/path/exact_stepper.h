// Exact steps within a linear phase, for those few that cannot be proven free of contact changes
// beforehand: where contacts change together, or a guard starts next to zero.
#pragma once

#include "motion/phase/exact_phases.h"
#include "motion/steps/stepper.h"

#include <memory>

namespace vibroimpact::motion {

class ExactStepper : public Stepper {
public:
  ExactStepper(const Equations &equations, const Settings &settings);
  ~ExactStepper() override;

  ExactPhases &phases() { return phases_; }
  /// True when everything is linear from `time` to the next break of the sources in the present
  /// modes of the contacts.
  bool handles(double time);

  /// After handles(time).
  void restart(double time, const Vector &x) override;
  void step(double limit) override;
  void shorten(double time) override { take(time); }
  void undo() override;
  void accept(bool keep_work) override;
  const GuardCurves *guard_curves() override;
  bool exact() const override { return true; }
  double fastest() const override { return phase_ ? phase_->phase().view().fastest : 0; }

  /// The motion was moved on by somebody else.
  void place(double time, const Vector &x);

private:
  class Guards;
  void begin();
  void take(double end);

  const Equations &equations_;
  ExactPhases phases_;
  std::shared_ptr<LinearPhase> phase_; ///< none: not begun
  std::unique_ptr<Guards> guards_;
  Amplitudes from_, to_; ///< at both ends of the last step
  bool pending_ = false; ///< the last step is not accepted yet
};

} // namespace vibroimpact::motion
