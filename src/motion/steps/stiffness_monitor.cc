#include "motion/steps/stiffness_monitor.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {

namespace {

constexpr long steps_between_looks = 100;
constexpr double stability_bound = 6;
// Steps that error control shortens and lengthens again have half of the bound on average.
constexpr double explicit_share = 0.4;
// Stages, their Newton iterations and the matrices of these cost about so much more.
constexpr double implicit_cost = 5;
constexpr int looks_in_a_row = 2;

// Largest |l| of eigenvalues that decay faster than they turn [1/s]. An internal state that is zero
// and decays by itself stays so in a step of any length.
double fastest_decay(const Equations &equations, double time, const Vector &x) {
  Matrix jacobian;
  equations.jacobian(time, ConstVectorView(x.data(), x.size()), jacobian);
  const Index size = equations.layout().physical_size();
  for (Index i = equations.layout().internal(); i < equations.layout().drive(); ++i)
    if (x[i] == 0 && jacobian.row(i).cwiseAbs().sum() == std::abs(jacobian(i, i)))
      jacobian(i, i) = 0;
  double fastest = 0;
  for (const auto &eigenvalue : eigenvalues(jacobian.topLeftCorner(size, size)))
    if (-eigenvalue.real() > std::abs(eigenvalue.imag()))
      fastest = std::max(fastest, std::abs(eigenvalue));
  return fastest;
}

} // namespace

bool StiffnessMonitor::due(double length) {
  sum_ += length;
  return ++steps_ % steps_between_looks == 0;
}

bool StiffnessMonitor::explicit_step(const Equations &equations, double time, const Vector &x,
                                     double length) {
  if (!due(length))
    return false;
  const double mean = std::exchange(sum_, 0) / steps_between_looks;
  if (wait_ > 0) {
    --wait_;
    return false;
  }
  const bool bound = mean * fastest_decay(equations, time, x) > explicit_share * stability_bound;
  stiff_ = bound ? stiff_ + 1 : 0;
  if (stiff_ < looks_in_a_row)
    return false;
  stiff_ = 0;
  return true;
}

bool StiffnessMonitor::implicit_step(const Equations &equations, double time, const Vector &x,
                                     double length) {
  if (!due(length))
    return false;
  const double mean = std::exchange(sum_, 0) / steps_between_looks;
  const bool short_steps =
      mean * fastest_decay(equations, time, x) < implicit_cost * stability_bound;
  if (short_steps)
    wait(pause_);
  return short_steps;
}

} // namespace vibroimpact::motion
