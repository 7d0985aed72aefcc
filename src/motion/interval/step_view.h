// Smooth parts of a motion between two instants, with dense output where they are steps.
#pragma once

#include "motion/interval/bernstein.h"
#include "motion/interval/end_point.h"
#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

/// What a contact's law sees during a step.
struct ContactCurves {
  Bernstein gap;
  Bernstein gap_rate;
  std::vector<Bernstein> internal;
  Bernstein normal_force; ///< in modes that hold the gap
};

/// A smooth part of a motion that is over, in the present modes of the equations. Valid only during
/// the call.
class Interval {
public:
  /// Times [s], and states with their work integrals.
  Interval(const Equations &equations, double start, const Vector &start_state, double end,
           const Vector &end_state)
      : equations_(&equations), start_(start), end_(end), start_state_(&start_state),
        end_state_(&end_state) {}

  double start() const { return start_; }
  double end() const { return end_; }
  double length() const { return end_ - start_; }
  const Equations &equations() const { return *equations_; }
  const Vector &start_state() const { return *start_state_; }
  const Vector &end_state() const { return *end_state_; }

private:
  const Equations *equations_;
  double start_, end_;
  const Vector *start_state_;
  const Vector *end_state_;
};

/// One that is short enough to be known by polynomials in tau = (t - start)/length: a step.
class StepView : public Interval {
public:
  StepView(const Equations &equations, const EndPoint &start, const EndPoint &end)
      : Interval(equations, start.time, start.state, end.time, end.state), start_(&start),
        end_(&end) {}

  /// Displacement seen by a projection, as a polynomial in tau = (t - start)/length: a quintic, or
  /// of degree 9 where the method knows higher derivatives at the ends.
  Bernstein displacement(const model::Projection &projection) const;
  /// Its time derivative, exact at both ends.
  Bernstein velocity(const model::Projection &projection) const;
  /// Its second time derivative, from the equations at both ends and the displacement between.
  Bernstein acceleration(const model::Projection &projection) const;
  /// One coordinate.
  Bernstein coordinate(Index j) const;

  Bernstein gap(std::size_t contact) const { return position(contact, 0); }
  /// Time derivative of the gap.
  Bernstein gap_rate(std::size_t contact) const { return rate(contact, 0); }
  /// Along a direction of a contact: the gap (0) or a slip, and its rate. In a circular gap through
  /// the values at ten instants: where u passes the middle the gap has no slope.
  Bernstein position(std::size_t contact, int direction) const;
  Bernstein rate(std::size_t contact, int direction) const;
  /// |u|^2 of a contact in a circular gap.
  Bernstein squared_distance(std::size_t contact) const;
  Bernstein internal(Index i) const;
  /// Torque of a motor.
  Bernstein drive(Index i) const;
  /// The force that holds a direction of a contact in its present mode; zero in other modes.
  Bernstein constraint_force(std::size_t contact, int direction = 0) const;
  /// Tangential force by the law, or the one that holds the sides.
  Bernstein friction_force(std::size_t contact, int direction) const;
  Bernstein indicator(std::size_t contact, const contact::AffineForm &form) const;

  ContactCurves contact_curves(std::size_t contact) const;
  /// Normal force at tau in the mode that holds during the step.
  double force(std::size_t contact, const ContactCurves &curves, double tau) const;
  /// Normal force at tau in the mode that holds during the step.
  double force(std::size_t contact, double tau) const;

private:
  Bernstein first_order_state(Index place) const;
  Bernstein circular_indicator(std::size_t contact, const contact::AffineForm &form) const;
  Bernstein margin(std::size_t contact) const;
  Bernstein internal_part(std::size_t contact, const contact::AffineForm &form) const;

  const EndPoint *start_;
  const EndPoint *end_;
};

} // namespace vibroimpact::motion
