// The modes of a system with bodies that turn, at any speed of one of its spins.
#pragma once

#include "model/assembled_system.h"

namespace vibroimpact::model {

/// Of each complex shape, a number from -1 to 1: the angular momentum of its vibration about the
/// spin axes over the largest that its size allows. 1: all points go round in circles with the
/// spin (forward whirl), -1: against it (backward whirl), 0: they move to and fro, or to equal
/// parts both ways. 0 where nothing turns or moves across an axis. Columns of `shapes` are
/// coordinates of the model.
Vector whirl_numbers(const Model &model, const ComplexMatrix &shapes);

class WhirlingSystem {
public:
  /// `spin`: position in model.spins(); the other ones keep their speeds at time zero. `system`
  /// must outlive it.
  WhirlingSystem(const Model &model, const AssembledSystem &system, std::size_t spin);

  /// At a speed [rad/s]. NumericalError when the eigenvalues do not converge.
  DampedModes at(double speed) const;
  const Model &model() const { return model_; }

private:
  const Model &model_;
  double speed_ = 0;     ///< of the spin in the model
  AssembledModes modes_; ///< at this speed
  Matrix gyroscopic_;    ///< of the spin, in these modes
  Matrix circulatory_;   ///< likewise; 0 x 0 without internal damping
  Matrix centrifugal_;   ///< likewise; 0 x 0 in the fixed frame
};

} // namespace vibroimpact::model
