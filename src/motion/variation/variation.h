// The variational equation along a motion: how small deviations of the state grow, through contact
// changes too.
//
// Between contact changes d' = J(x, t) d with the Jacobian J of the equations along the dense
// output. Where guard g(x, t) ends a mode and the state is reset to R(x, t), the deviating motion
// changes earlier or later than the reference by -g_x d / g', so that (Mueller 1995)
//
//   d+ = R_x d- + (f+ - R') (g_x d-) / g'         f  dx/dt before (-) and after (+) the change
//                                                 ' total time derivatives along f-
//
// Time-dependent gaps (moving bases) stand in g' and R'. A rigid impact resets the velocities, v+ =
// v- + M^-1 W^T p with impulses p that are linear in the gap rates before it. Where several
// contacts approach at one instant, deviating motions meet one after the other and there is no
// derivative; such collisions are passed by the first contact's guard and counted as tangential.
#pragma once

#include "motion/observer.h"

#include <vector>

namespace vibroimpact::motion {

/// Carries deviations of the physical state (coordinates, velocities, internal states, torques)
/// along, column by column.
class Variation : public Observer {
public:
  /// `equations` with the modes that hold at the start. `scale`: physical_size() factors that make
  /// deviations comparable; the error of a step stays below `tolerance` times the largest scaled
  /// entry of a column.
  Variation(const Equations &equations, Vector scale, double tolerance);

  /// physical_size() rows, any number of columns.
  void set_columns(const Matrix &columns);
  Matrix columns() const;
  /// Largest scaled entry of a column.
  double size(Index column) const { return scaled_.col(column).cwiseAbs().maxCoeff(); }
  /// Divides a column by its size.
  void normalise(Index column) { scaled_.col(column) /= size(column); }

  void step(const StepView &view) override;
  void event(const ContactEvent &event) override;

  /// Contact changes without a derivative: their guard had no rate at all, and they were passed as
  /// if their instant did not depend on the deviation; or several rigid contacts met at once.
  long tangential_events() const { return tangential_events_; }

private:
  RowVector gradient(std::size_t contact, const contact::AffineForm &form) const;
  double rate_along(std::size_t contact, const contact::AffineForm &form, const ContactEvent &event,
                    const Vector &rates) const;
  Vector rates(double time, const Vector &state) const;
  void collide(const ContactEvent &event);
  void jump(const Vector &change, Matrix &deviations, const RowVector &guard, double guard_rate);
  void reset(const ContactEvent &event, const Vector &before, Matrix &deviations,
             Vector &reset_rates) const;

  Equations equations_; ///< a copy: its modes follow the events
  Vector scale_;
  double tolerance_;
  Matrix scaled_; ///< scale * deviation
  long tangential_events_ = 0;
};

} // namespace vibroimpact::motion
