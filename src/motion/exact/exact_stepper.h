// Exact steps of linear phases.
#pragma once

#include "motion/energy/work_quadrature.h"
#include "motion/exact/linear_phase.h"
#include "motion/settings.h"
#include "motion/steps/stepper.h"

#include <memory>
#include <vector>

namespace vibroimpact::motion {

class ExactStepper : public Stepper {
public:
  ExactStepper(const Equations &equations, const Settings &settings);

  /// True when everything is linear from `time` to the next break of the sources in the present
  /// modes of the contacts.
  bool handles(double time);

  /// After handles(time). What steps need is made when the first one is taken: often none is.
  void restart(double time, const Vector &x) override;
  void step(double limit) override;
  void shorten(double time) override;
  void undo() override;
  void accept(bool keep_work) override;
  const GuardCurves *guard_curves() override;
  bool exact() const override { return true; }

  /// After handles(time): closed forms with that origin.
  const std::vector<model::ExponentialForm> &sources() const { return sources_; }
  /// The motion was moved on by somebody else.
  void place(double time, const Vector &x);

private:
  struct CachedPhase {
    std::vector<int> modes;
    std::unique_ptr<LinearPhase> phase; ///< none: not linear
  };
  CachedPhase &cached_phase();
  void begin();
  void fill(EndPoint &point) const;
  void take(double end);

  const Equations &equations_;
  double maximum_step_;
  DenseTolerance tolerance_;
  std::vector<CachedPhase> phases_;
  LinearPhase *phase_ = nullptr;
  LinearMotion *motion_ = nullptr; ///< none: not begun
  std::vector<model::ExponentialForm> sources_;
  WorkQuadrature work_;
  Matrix rows_, nodes_;
  Vector physical_;
  bool pending_ = false; ///< the last step is not accepted yet
};

} // namespace vibroimpact::motion
