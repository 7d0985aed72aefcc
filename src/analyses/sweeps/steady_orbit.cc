#include "analyses/sweeps/steady_orbit.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "periodic/contact_memory.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::analyses {

namespace {

// All over the size of the motion.
constexpr double first_step = 0.1;
constexpr double exact = 1e-11;       // what is left of the way
constexpr double motion_error = 1e-7; // steps below may be the error of the motion itself
constexpr double same_state = 1e-7;   // of two periods of one motion
// From one step to the next, at most, so that 1 / (1 - 0.3) = 1.4 times the next step is left of
// the way; where more than the second one, J is made anew.
constexpr double shrinkage = 0.3, slow = 0.1;
constexpr long most_maps = 12;
constexpr double stable = 1 - 1e-6; // largest multiplier
// Of multipliers, by a J that was made at a distance of one from the motion.
constexpr double multiplier_error = 10;

} // namespace

// The states after each of the periods; makes J.
std::vector<Vector> SteadyOrbitSearch::linearised(const Vector &state) {
  std::vector<Vector> states;
  Matrix by_state;
  motion::MotionState from{.time = static_cast<double>(cycle_) * period_, .physical = state};
  trajectory_.start(from);
  const std::vector<Index> unseen = periodic::idle_memory(trajectory_.equations());
  for (long k = 1; k <= multiple_; ++k) {
    const motion::LinearisedMotion motion =
        lineariser_(from, static_cast<double>(cycle_ + k) * period_);
    ++periods_;
    if (motion.without_derivative > 0)
      throw NumericalError("a contact change of the motion has no derivative");
    states.push_back(motion.end.physical);
    by_state = k == 1 ? motion.by_state : Matrix(motion.by_state * by_state);
    from = motion.end;
  }
  by_state(Eigen::all, unseen).setZero();
  by_state_ = scale_.asDiagonal() * by_state * scale_.cwiseInverse().asDiagonal();
  return states;
}

std::vector<Vector> SteadyOrbitSearch::carried(const Vector &state) {
  std::vector<Vector> states;
  trajectory_.start({.time = static_cast<double>(cycle_) * period_, .physical = state});
  for (long k = 1; k <= multiple_; ++k) {
    trajectory_.advance(static_cast<double>(cycle_ + k) * period_);
    ++periods_;
    states.push_back(trajectory_.motion_state().physical);
  }
  return states;
}

Vector SteadyOrbitSearch::newton_step(const Vector &residual) const {
  const Matrix matrix = Matrix::Identity(by_state_.rows(), by_state_.cols()) - by_state_;
  return LuFactors<Matrix>(matrix)
      .solve(Vector(residual.cwiseProduct(scale_)))
      .cwiseQuotient(scale_);
}

// None where the steps do not shrink. With the ratio r of the last two, r |d| / (1 - r) are left of
// the way at most.
std::optional<Vector> SteadyOrbitSearch::converge(const Vector &state, const Vector &image) {
  Vector step = newton_step(image - state);
  Vector point = state + step;
  double last = size(step) / std::max(size(state), size(point));
  if (!(last <= first_step))
    return std::nullopt;
  moved_ = last;
  for (bool anew = false;;) {
    if (periods_ >= most_maps * multiple_)
      return std::nullopt;
    step = newton_step((anew ? linearised(point) : carried(point)).back() - point);
    point += step;
    const double length = size(step) / size(point), ratio = length / last;
    moved_ = anew ? length : moved_ + length;
    if (ratio * length <= exact || (length <= motion_error && ratio >= shrinkage))
      return point;
    if (!(ratio <= shrinkage))
      return std::nullopt;
    anew = ratio > slow;
    last = length;
  }
}

// Its states in all periods, and the least number of periods after which it repeats itself.
std::vector<Vector> SteadyOrbitSearch::states_from(const Vector &point) {
  std::vector<Vector> states{point};
  if (multiple_ == 1)
    return states;
  const std::vector<Vector> further = carried(point);
  states.insert(states.end(), further.begin(), further.end() - 1);
  for (long j = 1; j < multiple_; ++j)
    if (multiple_ % j == 0 &&
        size(states[static_cast<std::size_t>(j)] - point) <= same_state * size(point)) {
      states.resize(static_cast<std::size_t>(j));
      multiple_ = j;
      moved_ = std::numeric_limits<double>::infinity(); // J is that of more periods
    }
  return states;
}

std::optional<SteadyOrbit> SteadyOrbitSearch::stable_orbit(const Vector &point) {
  std::vector<Vector> states = states_from(point);
  double multiplier = periodic::spectral_radius(by_state_);
  if (moved_ > 0 && !(multiplier + multiplier_error * moved_ <= stable)) {
    linearised(point);
    multiplier = periodic::spectral_radius(by_state_);
  }
  if (!(multiplier <= stable))
    return std::nullopt;
  return SteadyOrbit{.states = std::move(states),
                     .norm = periodic::AdaptedNorm(by_state_, multiplier)};
}

SteadyOrbitSearch::Result SteadyOrbitSearch::run(const Vector &state, long cycle, long multiple) {
  Result result;
  cycle_ = cycle;
  multiple_ = multiple;
  periods_ = 0;
  try {
    result.carried = linearised(state);
    if (const std::optional<Vector> point = converge(state, result.carried.back()))
      result.orbit = stable_orbit(*point);
  } catch (const NumericalError &) { // the motion goes on by itself, which says what is wrong
  }
  result.periods = periods_;
  return result;
}

} // namespace vibroimpact::analyses
