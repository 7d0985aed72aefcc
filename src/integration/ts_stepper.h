// One PETSc TS that advances the equations step by step and can take its last step again shorter.
//
// TSSolve and its event handler are not used: that handler skips the sign check in the step after
// an event and loses grazing sequences. Here the caller looks at every accepted step by itself,
// shortens it to the event it found, and restarts the method there.
#pragma once

#include "integration/equations.h"
#include "integration/settings.h"

// PETSc's objects under its own names; its headers stay in ts_stepper.cc.
// NOLINTBEGIN(bugprone-reserved-identifier)
struct _p_TS;
struct _p_Vec;
struct _p_Mat;
// NOLINTEND(bugprone-reserved-identifier)

namespace vibroimpact {

class TsStepper {
public:
  TsStepper(Equations &equations, const IntegrationSettings &settings);
  ~TsStepper();
  TsStepper(const TsStepper &) = delete;
  TsStepper &operator=(const TsStepper &) = delete;

  /// Begins a new smooth phase at (time, x) with a first trial step.
  void restart(double time, const Vector &x, double first_step);

  /// Takes one accepted step that ends at `limit` at the latest. NumericalError when the method
  /// gives up or the state is no longer finite.
  void step(double limit);

  /// Takes the last step again so that it ends at `time` (inside it), from the same start.
  void shorten(double time);

  /// Undoes the last step.
  void undo();

  double time() const { return time_; }
  double previous_time() const { return previous_time_; }
  const Vector &state() const { return state_; }
  const Vector &previous_state() const { return previous_state_; }
  /// Step the error control would take next if nothing limited it [s].
  double natural_step() const { return natural_step_; }
  long rejected_steps() const;

private:
  void set_tolerances(const IntegrationSettings &settings);
  void set_method(const std::string &method);
  void attempt(double end);
  void take(double end);
  void load(const Vector &x);
  void unload();

  Equations &equations_;
  double maximum_step_;
  _p_TS *ts_ = nullptr;
  _p_Vec *solution_ = nullptr;
  _p_Mat *jacobian_ = nullptr;
  double time_ = 0;
  double previous_time_ = 0;
  double natural_step_ = 0;
  Vector state_;
  Vector previous_state_;
};

} // namespace vibroimpact
