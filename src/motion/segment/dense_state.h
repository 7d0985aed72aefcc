// The whole state along one step, from its polynomials.
#pragma once

#include "motion/observer.h"

#include <vector>

namespace vibroimpact::motion {

class DenseState {
public:
  explicit DenseState(const StepView &view);

  /// The state at tau in [0, 1], the work integrals at zero.
  void at(double tau, Vector &state) const;

private:
  StateLayout layout_;
  std::vector<Bernstein> coordinates_, velocities_, others_;
};

} // namespace vibroimpact::motion
