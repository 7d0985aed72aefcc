// A stock PETSc TS that advances the equations step by step and can take its last step again
// shorter.
//
// TSSolve and its event handler are not used: that handler skips the sign check in the step after
// an event and loses grazing sequences. Here the caller looks at every accepted step by itself,
// shortens it to the event it found, and restarts the method there.
#pragma once

#include "motion/settings.h"
#include "motion/steps/error_measure.h"
#include "motion/steps/source_step.h"
#include "motion/steps/stepper.h"
#include "motion/system/equations.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

// PETSc's objects under its own names; its headers stay in ts_stepper.cc.
// NOLINTBEGIN(bugprone-reserved-identifier)
struct _p_TS;
struct _p_Vec;
struct _p_Mat;
// NOLINTEND(bugprone-reserved-identifier)

namespace vibroimpact::motion {

class TsStepper : public Stepper {
public:
  /// `method`: one of the types of a stock TS.
  /// `order`: of the method, where it is "arkimex"; 0: as PETSc has it.
  TsStepper(Equations &equations, const Settings &settings, const std::string &method,
            int order = 0);
  ~TsStepper() override;
  TsStepper(const TsStepper &) = delete;
  TsStepper &operator=(const TsStepper &) = delete;

  void forget() override;
  void restart(double time, const Vector &x) override;
  void step(double limit) override;
  void shorten(double time) override;
  void undo() override;
  long rejected_steps() const override;

private:
  void set_tolerances(const Settings &settings);
  void set_method(const std::string &method, int order);
  double first_step() const;
  void attempt(double end);
  void take(double end);
  void roll_back();
  void load(const Vector &x);
  void unload();
  void complete(EndPoint &point) const;

  Equations &equations_;
  double maximum_step_;
  ErrorMeasure measure_;
  SourceStep source_step_;
  _p_TS *ts_ = nullptr;
  _p_Vec *solution_ = nullptr;
  _p_Mat *jacobian_ = nullptr;
  double natural_step_ = 0; ///< the error control would take next if nothing limited it [s]
  std::optional<std::vector<int>> phase_modes_;      ///< of the present phase
  std::map<std::vector<int>, double> step_of_modes_; ///< natural step at the end of the last phase
};

} // namespace vibroimpact::motion
