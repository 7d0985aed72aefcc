#include "motion/variation/linearised_motion.h"

namespace vibroimpact::motion {

LinearisedMotion linearise(Trajectory &trajectory, const MotionState &start, double end,
                           const VariationAccuracy &accuracy, const std::vector<KeyTangent *> &keys,
                           Observer *also) {
  trajectory.start(start);
  const Index size = trajectory.layout().physical_size();
  Variation variation(trajectory, accuracy.scale, accuracy.tolerance, keys);
  variation.set_columns(Matrix::Identity(size, size));
  std::vector<Observer *> observers = {&variation};
  if (also)
    observers.push_back(also);
  Observers all(std::move(observers));
  trajectory.advance(end, all);
  Vector rates(trajectory.layout().size());
  const Vector &state = trajectory.state();
  trajectory.equations().rates(end, ConstVectorView(state.data(), state.size()),
                               VectorView(rates.data(), rates.size()));
  return {.end = trajectory.motion_state(),
          .by_state = variation.columns(),
          .by_key = variation.key_columns(),
          .rates = rates.head(size),
          .determinant = variation.determinant(),
          .events = trajectory.accuracy().events,
          .without_derivative = variation.tangential_events()};
}

} // namespace vibroimpact::motion
