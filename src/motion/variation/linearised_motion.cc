#include "motion/variation/linearised_motion.h"

namespace vibroimpact::motion {

LinearisedMotion Lineariser::operator()(const MotionState &start, double end,
                                        const std::vector<KeyTangent *> &keys, Observer *also) {
  trajectory_.start(start);
  if (variation_)
    variation_->begin(trajectory_, keys);
  else
    variation_.emplace(trajectory_, accuracy_.scale, accuracy_.tolerance, keys);
  const Index size = trajectory_.layout().physical_size();
  variation_->set_columns(Matrix::Identity(size, size));
  trajectory_.advance(end, also ? Observers({&*variation_, also}) : Observers(*variation_));
  Vector rates(trajectory_.layout().size());
  const Vector &state = trajectory_.state();
  trajectory_.equations().rates(end, ConstVectorView(state.data(), state.size()),
                                VectorView(rates.data(), rates.size()));
  rates.conservativeResize(size);
  return {.end = trajectory_.motion_state(),
          .by_state = variation_->columns(),
          .by_key = variation_->key_columns(),
          .rates = std::move(rates),
          .determinant = variation_->determinant(),
          .events = trajectory_.events(),
          .without_derivative = variation_->tangential_events()};
}

} // namespace vibroimpact::motion
