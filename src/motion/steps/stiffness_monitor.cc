#include "motion/steps/stiffness_monitor.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::motion {

namespace {

constexpr long steps_between_looks = 100;
constexpr double stability_bound = 6;
// A decay l that is alive keeps steps h of order 8 and a tolerance of 1e-9 or less to h l < 0.5,
// (h l)^9 / 9! being the error. Longer ones over 200 steps, in which it falls by exp(-100), are
// ruled by their stability alone: near its bound, or well below it where the errors of a step are
// large against a tight tolerance there.
constexpr double explicit_share = 0.1;
// Stages, their Newton iterations and the matrices of these cost about so much more.
constexpr double implicit_cost = 5;
constexpr int looks_in_a_row = 2;

// Largest |l| of eigenvalues that decay faster than they turn [1/s].
double fastest_decay(const Equations &equations, double time, const Vector &x) {
  Matrix jacobian;
  equations.jacobian(time, ConstVectorView(x.data(), x.size()), jacobian);
  const Index size = equations.layout().physical_size();
  const Eigen::EigenSolver<Matrix> solver(jacobian.topLeftCorner(size, size), false);
  double fastest = 0;
  for (const auto &eigenvalue : solver.eigenvalues())
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
  if (trials_ >= most_trials || !due(length))
    return false;
  const double mean = std::exchange(sum_, 0) / steps_between_looks;
  const bool bound = mean * fastest_decay(equations, time, x) > explicit_share * stability_bound;
  stiff_ = bound ? stiff_ + 1 : 0;
  if (stiff_ < looks_in_a_row)
    return false;
  stiff_ = 0;
  ++trials_;
  return true;
}

bool StiffnessMonitor::implicit_step(const Equations &equations, double time, const Vector &x,
                                     double length) {
  if (!due(length))
    return false;
  const double mean = std::exchange(sum_, 0) / steps_between_looks;
  return mean * fastest_decay(equations, time, x) < implicit_cost * stability_bound;
}

} // namespace vibroimpact::motion
