// The method of a motion: which stepper integrates which phase.
#pragma once

#include "motion/path/exact_stepper.h"
#include "motion/steps/stepper.h"
#include "motion/steps/stiffness_monitor.h"

#include <memory>

namespace vibroimpact::motion {

class Steppers {
public:
  /// Method "exact": exact steps where the phase is linear; elsewhere Runge-Kutta of order 8, and
  /// a diagonally implicit method as long as the phase is stiff. Any other: that TS throughout.
  Steppers(Equations &equations, const Settings &settings);

  /// Begins a phase with the stepper that suits the present modes of the equations.
  void restart(double time, const Vector &x);
  /// Takes one step of the present phase, as Stepper::step() does.
  void step(double limit);
  Stepper &present() { return *present_; }
  const Stepper &present() const { return *present_; }

  /// The exact method, where it may be used at all.
  ExactStepper *exact() { return exact_.get(); }
  /// The motion was moved on by somebody else; the next phase must begin with restart().
  void place(double time, const Vector &x);

  void forget();
  long rejected_steps() const;

private:
  void choose();
  void go_on_with(Stepper &stepper);
  void step_implicitly(double limit);

  Equations &equations_;
  const Settings settings_;
  std::unique_ptr<Stepper> general_;
  std::unique_ptr<ExactStepper> exact_;
  std::unique_ptr<Stepper> implicit_; ///< for stiff phases; none before the first of them
  StiffnessMonitor stiffness_;
  Stepper *present_;
};

} // namespace vibroimpact::motion
