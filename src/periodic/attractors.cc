#include "periodic/attractors.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <algorithm>

namespace vibroimpact::periodic {

namespace {

constexpr double recurrence = 1e-4; ///< of the largest state so far
/// Nearer than that to a known motion Newton's method would find it again, for every start.
constexpr double near_known = 1e-2;
/// Fixed points nearer than that, relative to their size, are one: Newton's error is below 1e-10.
constexpr double same_motion = 1e-7;

double difference(const Vector &a, const Vector &b) { return (a - b).cwiseAbs().maxCoeff(); }

} // namespace

std::optional<std::size_t> Attractors::trapped(const Vector &state, double share) const {
  for (std::size_t a = 0; a < list_.size(); ++a)
    if (list_[a].ball.contains(state, share))
      return a;
  return {};
}

std::optional<std::size_t> Attractors::nearest(const Vector &state, double distance) const {
  for (std::size_t a = 0; a < list_.size(); ++a)
    for (const Vector &known : list_[a].states)
      if (difference(known, state) < distance)
        return a;
  return {};
}

std::size_t Attractors::add(const FoundMotion &motion) {
  std::vector<Vector> states = {motion.state};
  for (long k = 1; k < motion.multiple; ++k)
    states.push_back(map_(states.back()));
  TrappingBall ball(power_of(map_, motion.multiple), motion.state, motion.by_state,
                    settings_.largest);
  list_.push_back({.motion = motion,
                   .states = std::move(states),
                   .multipliers = eigenvalues(motion.by_state),
                   .ball = std::move(ball)});
  return list_.size() - 1;
}

// A state that returns is near a periodic motion, or moves past one slowly.
std::optional<std::size_t> Attractors::recognise(const Vector &state, long multiple, double size) {
  if (nearest(state, near_known * size))
    return {};
  const std::optional<FoundMotion> found = newton_(state, multiple);
  if (!found || !(eigenvalues(found->by_state).cwiseAbs().maxCoeff() < 1) ||
      difference(found->state, state) > near_known * size)
    return {};
  if (const auto known = nearest(found->state, same_motion * size))
    return known;
  return add(*found);
}

Decision Attractors::follow(const Vector &start, const StateMap &map, double share) {
  Vector state = start, earlier = start;
  double size = start.cwiseAbs().maxCoeff();
  long since = 0, until = 1; // of the earlier state
  for (long period = 1; period <= settings_.most_periods; ++period) {
    try {
      state = map(state);
    } catch (const NumericalError &) {
      return {.outcome = Outcome::failed, .attractor = 0, .periods = period};
    }
    if (!state.allFinite())
      return {.outcome = Outcome::failed, .attractor = 0, .periods = period};
    if (const auto known = trapped(state, share))
      return {.outcome = Outcome::decided, .attractor = *known, .periods = period};
    size = std::max(size, state.cwiseAbs().maxCoeff());
    ++since;
    if (since <= settings_.longest_multiple && difference(state, earlier) < recurrence * size)
      if (const auto found = recognise(state, since, size))
        return {.outcome = Outcome::decided, .attractor = *found, .periods = period};
    if (since == until) {
      earlier = state;
      since = 0;
      until *= 2;
    }
  }
  return {.outcome = Outcome::undecided, .attractor = 0, .periods = settings_.most_periods};
}

void Attractors::choose(const std::vector<std::size_t> &places) {
  std::vector<Attractor> chosen;
  chosen.reserve(places.size());
  for (const std::size_t place : places)
    chosen.push_back(list_.at(place));
  list_ = std::move(chosen);
}

} // namespace vibroimpact::periodic
