#include "motion/episode/other_guards.h"

#include "common/memory.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

void OtherGuards::set_reach(const double *x, double duration) {
  const ExactPhase &phase = linear_.phase();
  const auto padded = static_cast<std::size_t>(phase.view().n_padded);
  reach_.assign(padded, 0);
  for (const PhaseGroup &group : phase.groups()) {
    const auto first = static_cast<std::size_t>(group.first);
    if (group.kind != BlockKind::dense) {
      const double growth = std::exp(std::max(0.0, group.exponent.real() * duration));
      reach_[first] = growth * (std::abs(x[first]) + std::abs(x[first + padded]));
      continue;
    }
    const Matrix step = duration * group.generator.cwiseAbs();
    Vector term = ConstVectorView(x + first, step.rows()).cwiseAbs();
    VectorView sum(reach_.data() + first, step.rows());
    sum = term;
    constexpr int most_terms = 60;
    for (int k = 1; k < most_terms; ++k) {
      term = step * term / k;
      sum += term;
    }
  }
}

double OtherGuards::second_derivative(std::size_t form) const {
  const PhaseView &view = linear_.phase().view();
  const auto n = static_cast<std::size_t>(view.n_padded);
  double sum = 0;
  for (std::size_t j = 0; j < n; ++j)
    sum += view.second[form * n + j] * reach_[j];
  return sum;
}

void OtherGuards::bound_free_motion(const double *amplitudes, double duration) {
  const PhaseView &view = linear_.phase().view();
  set_reach(amplitudes, duration);
  const std::vector<double> exact(least_.size(), 0.0);
  for (std::size_t i = 0; i < least_.size(); ++i) {
    double f[4];
    kernel().derivatives(view, static_cast<int>(i), amplitudes, f);
    const double bend = 0.5 * duration * duration * second_derivative(i) +
                        kernel().guard_margin(view, static_cast<int>(i), amplitudes, exact.data());
    least_[i] = f[0] + std::min(0.0, f[1] * duration) - bend;
    most_[i] = f[0] + std::max(0.0, f[1] * duration) + bend;
  }
}

void OtherGuards::add(const Push &push, double duration) {
  const PhaseView &view = linear_.phase().view();
  set_reach(push.load, duration);
  for (std::size_t i = 0; i < least_.size(); ++i) {
    double f[4];
    kernel().derivatives(view, static_cast<int>(i), push.load, f);
    const double value = f[0] - view.constants[i];
    const double bend = 0.5 * duration * duration * second_derivative(i);
    const double down = std::max(0.0, -value) + duration * std::max(0.0, -f[1]) + bend;
    const double up = std::max(0.0, value) + duration * std::max(0.0, f[1]) + bend;
    least_[i] -= push.pushing * down + push.pulling * up;
    most_[i] += push.pushing * up + push.pulling * down;
  }
}

double OtherGuards::least_of_guard(std::size_t guard) const {
  const SquaresView *const squares = linear_.phase().view().squares;
  if (!squares || squares[guard].first == 0)
    return least_[guard];
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t form = static_cast<std::size_t>(squares[guard].first) + i;
    const double factor = i == 0 ? squares[guard].scale : -squares[guard].scale;
    const double large = std::max(std::abs(least_[form]), std::abs(most_[form]));
    const double small = std::max({0.0, least_[form], -most_[form]});
    sum += factor * (factor > 0 ? small * small : large * large);
  }
  return sum;
}

std::size_t OtherGuards::bytes() const { return bytes_of(reach_, least_, most_); }

bool OtherGuards::stay_positive(std::size_t contact, const double *amplitudes, double duration,
                                std::span<const Push> pushes) {
  const std::vector<PhaseGuard> &guards = linear_.forms().guards();
  const auto other = [&](const PhaseGuard &guard) { return guard.contact != contact; };
  if (std::none_of(guards.begin(), guards.end(), other))
    return true;
  const auto count = static_cast<std::size_t>(linear_.phase().view().n_forms);
  least_.resize(count);
  most_.resize(count);
  bound_free_motion(amplitudes, duration);
  for (const Push &push : pushes)
    add(push, duration);
  for (std::size_t g = 0; g < guards.size(); ++g)
    if (other(guards[g]) && !(least_of_guard(g) > 0))
      return false;
  return true;
}

} // namespace vibroimpact::motion
