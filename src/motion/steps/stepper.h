// What takes the steps of a motion within one smooth phase.
#pragma once

#include "motion/interval/end_point.h"
#include "motion/interval/guard_curves.h"

namespace vibroimpact::motion {

class Stepper {
public:
  virtual ~Stepper() = default;

  /// Forgets what earlier motions taught it about step lengths, so that a motion does not depend on
  /// what was integrated before.
  virtual void forget() {}

  /// Begins a new smooth phase at (time, x).
  virtual void restart(double time, const Vector &x) = 0;

  /// Takes one accepted step that ends at `limit` at the latest. NumericalError when the method
  /// gives up or the state is no longer finite.
  virtual void step(double limit) = 0;

  /// Takes the last step again so that it ends at `time` (after its start), from the same start.
  virtual void shorten(double time) = 0;

  /// The guards of the contacts' present modes during the last step, in the order of
  /// guard_forms(), where the method knows them exactly; nullptr: only the dense output tells.
  virtual const GuardCurves *guard_curves() { return nullptr; }

  /// Undoes the last step.
  virtual void undo() = 0;

  /// The last step is final: completes the work integrals at its end if that is kept.
  virtual void accept(bool /*keep_work*/) {}

  virtual long rejected_steps() const { return 0; }

  /// True when steps have no error but rounding.
  virtual bool exact() const { return false; }

  /// Largest |exponent| of a linear phase [1/s]; 0: not known.
  virtual double fastest() const { return 0; }

  double time() const { return end_.time; }
  double previous_time() const { return start_.time; }
  const Vector &state() const { return end_.state; }
  /// Ends of the last step, with everything that is known there.
  const EndPoint &start_point() const { return start_; }
  const EndPoint &end_point() const { return end_; }

protected:
  EndPoint start_;
  EndPoint end_;
};

} // namespace vibroimpact::motion
