// A motion at one instant together with its derivative by a key.
//
// y = [x, then s, s', s'' of each source] is what linear forms of the motion refer to
// (motion::LinearRow). At a fixed time
//
//   dy/dp  = [dx/dp, ds/dp, ...]      dx/dp from the variational equation
//   dy'/dp = [J dx/dp + df/dp, ...]   J = df/dx in the present modes
//
// and along the motion y' = [f, s', s'', s'''], y'' = [df/dt + J f, ...]. Where the equations do
// not give a derivative by time themselves it is a difference of the equations along x + h f; the
// motion is never differenced.
#pragma once

#include "motion/interval/observer.h"
#include "motion/variation/key_tangent.h"

#include <optional>

namespace vibroimpact::analyses {

class TangentPoint {
public:
  /// Keeps references. `equations` in the modes that hold; `state` with its work integrals;
  /// `change`: dx/dp at the fixed time, physical_size() entries.
  TangentPoint(const motion::Equations &equations, const motion::KeyTangent &key, double time,
               const Vector &state, Vector change);

  const motion::Equations &equations() const { return equations_; }
  double time() const { return time_; }
  const Vector &state() const { return state_; }
  const motion::KeyTangent &key() const { return key_; }

  /// physical_size() + 3 sources entries each, made when first asked for.
  const Vector &values() const { return values_; } ///< y
  const Vector &change() const { return change_; } ///< dy/dp
  const Vector &rates() const { return rates_; }   ///< y'
  const Vector &second_rates() const;              ///< y'', but for s''''
  const Vector &change_of_rates() const;           ///< dy'/dp, but for ds'''/dp

private:
  Vector values_at(double time, const Vector &state) const;
  Vector rates_at(double time, const Vector &state) const;
  double time_step() const;

  const motion::Equations &equations_;
  const motion::KeyTangent &key_;
  double time_;
  const Vector &state_;
  Vector values_, change_, rates_;
  mutable std::optional<Vector> second_rates_, change_of_rates_;
};

/// An event with what deviating motions make of it.
struct TangentEvent {
  const motion::ContactEvent &event;
  const TangentPoint &before, &after;
  double delay = 0; ///< dt/dp of its instant; NaN: it has none
};

/// Sees a motion with its derivative at chosen instants and on both sides of every event.
class TangentVisitor {
public:
  virtual ~TangentVisitor() = default;
  virtual std::vector<double> stops() const = 0; ///< ascending [s]
  /// The motion stands at the stop of this place in the list.
  virtual void stop(std::size_t place, const TangentPoint &at) = 0;
  virtual void event(const TangentEvent &event) = 0;
};

} // namespace vibroimpact::analyses
