#include "motion/exact/linear_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

// Error of the Hermite polynomial of degree 2 p - 1: |f^(2p)| h^(2p) / ((2p)! 4^p).
double dense_step(double tenth_derivative, double eighth_derivative) {
  constexpr double ten_factorial = 3628800;
  constexpr double eight_factorial = 40320;
  double step = std::numeric_limits<double>::infinity();
  if (tenth_derivative > 0)
    step = std::min(step, std::pow(ten_factorial * 1024 / tenth_derivative, 0.1));
  if (eighth_derivative > 0)
    step =
        std::min(step, std::sqrt(std::sqrt(std::sqrt(eight_factorial * 256 / eighth_derivative))));
  return step;
}

LinearPhase::LinearPhase(const Equations &equations, const DenseTolerance &tolerance)
    : system_(equations) {
  const GuardForms guards = guard_forms(equations);
  const Index n = equations.layout().n;
  if (system_.diagonalizable()) {
    modal_ = make_modal_motion(system_, n, tolerance);
    modal_->watch(guards);
  }
  taylor_ = make_taylor_motion(system_, n, tolerance);
  taylor_->watch(guards);
}

LinearMotion &LinearPhase::begin(const Vector &y, std::span<const model::ExponentialForm> sources) {
  if (modal_ && modal_->begin(y, sources))
    return *modal_;
  taylor_->begin(y, sources);
  return *taylor_;
}

} // namespace vibroimpact::motion
