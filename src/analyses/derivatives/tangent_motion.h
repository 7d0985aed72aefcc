// A motion led along once more beside its derivative by a key, stopped at chosen instants and shown
// on both sides of every event.
#pragma once

#include "analyses/derivatives/form_tangents.h"
#include "motion/path/trajectory.h"
#include "motion/variation/variation.h"

namespace vibroimpact::analyses {

/// An event with what deviating motions make of it.
struct TangentEvent {
  const motion::ContactEvent &event;
  const TangentPoint &before, &after;
  double delay = 0; ///< dt/dp of its instant; NaN: it has none
};

class TangentVisitor {
public:
  virtual ~TangentVisitor() = default;
  /// The motion stands at the stop of this place in the list.
  virtual void stop(std::size_t place, const TangentPoint &at) = 0;
  virtual void event(const TangentEvent &event) = 0;
};

/// Where the motion starts and how its state there changes with the key at the fixed time.
struct TangentStart {
  motion::MotionState state;
  Vector change; ///< physical_size() entries per unit of the key
};

/// Advances the trajectory to the stops one after the other [s, ascending], then to `end`. `forms`
/// and `key` are of its system. NumericalError, Interrupted.
void follow_tangent(motion::Trajectory &trajectory, const TangentStart &start,
                    const std::vector<double> &stops, double end, motion::KeyTangent &key,
                    const motion::VariationAccuracy &accuracy, FormTangents &forms,
                    TangentVisitor &visitor);

} // namespace vibroimpact::analyses
