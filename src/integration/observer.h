// What a motion shows while it is integrated: smooth steps with dense output, and contact changes.
#pragma once

#include "integration/bernstein.h"
#include "integration/equations.h"

#include <vector>

namespace vibroimpact {

/// What a contact's law sees during a step.
struct ContactCurves {
  Bernstein gap;
  Bernstein gap_rate;
  std::vector<Bernstein> internal;
};

/// One accepted step, smooth inside. Valid only during the call.
class StepView {
public:
  StepView(const Equations &equations, double start, double end, const Vector &start_state,
           const Vector &end_state, const Vector &start_rates, const Vector &end_rates);

  double start() const { return start_; }
  double end() const { return end_; }
  double length() const { return end_ - start_; }
  const Equations &equations() const { return *equations_; }
  const Vector &start_state() const { return *start_state_; }
  const Vector &end_state() const { return *end_state_; }

  /// Displacement seen by a projection, as a quintic in tau = (t - start)/length.
  Bernstein displacement(const Projection &projection) const;
  /// Its time derivative.
  Bernstein velocity(const Projection &projection) const;
  /// Its second time derivative, from the equations at both ends and the displacement between.
  Bernstein acceleration(const Projection &projection) const;
  /// One coordinate.
  Bernstein coordinate(Index j) const;

  Bernstein gap(std::size_t contact) const;
  /// Time derivative of the gap.
  Bernstein gap_rate(std::size_t contact) const;
  Bernstein internal(Index i) const;
  /// Torque of a motor.
  Bernstein drive(Index i) const;
  Bernstein indicator(std::size_t contact, const AffineForm &form) const;

  ContactCurves contact_curves(std::size_t contact) const;
  /// Normal force at tau in the mode that holds during the step.
  double force(std::size_t contact, const ContactCurves &curves, double tau) const;
  /// Normal force at tau in the mode that holds during the step.
  double force(std::size_t contact, double tau) const;

private:
  Bernstein first_order_state(Index place) const;

  const Equations *equations_;
  double start_;
  double end_;
  const Vector *start_state_;
  const Vector *end_state_;
  const Vector *start_rates_;
  const Vector *end_rates_;
};

/// A contact that changed its mode.
struct ContactEvent {
  double time = 0;
  std::size_t contact = 0;
  int from = 0;
  int to = 0;
  double gap = 0;      ///< [m]
  double gap_rate = 0; ///< [m/s]
  const Vector *state = nullptr;
  const Vector *before = nullptr; ///< the state before the resets of the guard
  const Guard *guard = nullptr;   ///< that was passed
  const StateLayout *layout = nullptr; ///< of the state
};

class Observer {
public:
  virtual ~Observer() = default;
  virtual void step(const StepView &view) = 0;
  virtual void event(const ContactEvent & /*event*/) {}
};

/// Passes everything on to several observers.
class Observers : public Observer {
public:
  explicit Observers(std::vector<Observer *> list) : list_(std::move(list)) {}
  void step(const StepView &view) override {
    for (Observer *observer : list_)
      observer->step(view);
  }
  void event(const ContactEvent &event) override {
    for (Observer *observer : list_)
      observer->event(event);
  }

private:
  std::vector<Observer *> list_;
};

} // namespace vibroimpact
