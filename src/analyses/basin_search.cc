#include "analyses/basin_search.h"

#include "analyses/orbit_start.h"
#include "common/error.h"
#include "periodic/orbit.h"

#include <algorithm>
#include <numeric>

namespace vibroimpact::analyses {

using periodic::Attractors;
using periodic::Decision;
using periodic::FoundMotion;
using periodic::Outcome;

BasinSearch::BasinSearch(System system, std::size_t source,
                         const periodic::AttractorSettings &settings)
    : system_(std::move(system)),
      forced_(system_.model, system_.contacts, system_.integration, source),
      map_(forced_, orbit_accuracy(system_, forced_)), settings_(settings) {}

Vector BasinSearch::scaled_start(const model::InitialState &start) {
  motion::Trajectory &trajectory = forced_.trajectory();
  trajectory.start(0, start.displacement, start.velocity);
  return trajectory.motion_state().physical.cwiseProduct(map_.scale());
}

Vector BasinSearch::image(const Vector &scaled) {
  motion::Trajectory &trajectory = forced_.trajectory();
  trajectory.start({.time = 0, .physical = scaled.cwiseQuotient(map_.scale())});
  trajectory.advance(forced_.period());
  return trajectory.motion_state().physical.cwiseProduct(map_.scale());
}

// Shooting finds the motion with a section away from its contact changes; from there it goes to
// phase 0, where starts are given.
std::optional<FoundMotion> BasinSearch::find(const Vector &scaled, long multiple) {
  try {
    const Vector guess = scaled.cwiseQuotient(map_.scale());
    const periodic::Orbit orbit = find_orbit(map_, multiple, guess);
    if (!periodic::is_stable(orbit.multipliers(map_)))
      return {};
    const Vector state = state_at_zero_phase(map_, orbit);
    const Matrix by_state =
        map_.image({.phase = 0, .halves = 2 * orbit.multiple()}, state).by_state;
    const Vector &scale = map_.scale();
    return FoundMotion{.state = state.cwiseProduct(scale),
                       .multiple = orbit.multiple(),
                       .by_state =
                           scale.asDiagonal() * by_state * scale.cwiseInverse().asDiagonal()};
  } catch (const NumericalError &) { // nothing there that shooting could find
    return {};
  }
}

void BasinSearch::search(const std::vector<model::InitialState> &starts) {
  std::vector<Vector> states;
  double largest = 0;
  for (const model::InitialState &start : starts)
    try {
      states.push_back(scaled_start(start));
      largest = std::max(largest, states.back().norm());
    } catch (const InputError &) { // rigid sides overlap there
    }
  settings_.largest = largest > 0 ? largest : 1;
  attractors_.emplace([this](const Vector &state) { return image(state); },
                      [this](const Vector &state, long multiple) { return find(state, multiple); },
                      settings_);
  for (const Vector &state : states)
    attractors_->follow(state);
  const auto &list = attractors_->list();
  std::vector<std::size_t> order(list.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return list[a].motion.state.norm() < list[b].motion.state.norm();
  });
  attractors_->choose(order);
}

Decision BasinSearch::follow(const model::InitialState &start) {
  try {
    return attractors_->follow(scaled_start(start));
  } catch (const InputError &) { // rigid sides overlap there
    return {.outcome = Outcome::failed};
  }
}

} // namespace vibroimpact::analyses
