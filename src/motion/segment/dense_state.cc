#include "motion/segment/dense_state.h"

namespace vibroimpact::motion {

DenseState::DenseState(const StepView &view) : layout_(view.equations().layout()) {
  for (Index j = 0; j < layout_.n; ++j) {
    coordinates_.push_back(view.coordinate(j));
    velocities_.push_back(
        view.velocity({.row = RowVector::Unit(layout_.n, j), .base_coefficients = {}}));
  }
  for (Index i = 0; i < layout_.n_internal; ++i)
    others_.push_back(view.internal(i));
  for (Index i = 0; i < layout_.n_drive; ++i)
    others_.push_back(view.drive(i));
}

void DenseState::at(double tau, Vector &state) const {
  state.setZero(layout_.size());
  for (std::size_t j = 0; j < coordinates_.size(); ++j) {
    state[static_cast<Index>(j)] = coordinates_[j](tau);
    state[layout_.velocity() + static_cast<Index>(j)] = velocities_[j](tau);
  }
  for (std::size_t i = 0; i < others_.size(); ++i)
    state[layout_.internal() + static_cast<Index>(i)] = others_[i](tau);
}

} // namespace vibroimpact::motion
