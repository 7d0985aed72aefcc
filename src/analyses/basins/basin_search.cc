#include "analyses/basins/basin_search.h"

#include "analyses/curves/orbit_start.h"
#include "analyses/keys/keyed_system.h"
#include "common/error.h"
#include "periodic/contact_memory.h"
#include "periodic/orbit.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace vibroimpact::analyses {

using periodic::Decision;
using periodic::FoundMotion;

namespace {

constexpr double reach_of_nodes = 1.35; ///< motions leave the region of their starts
/// Of a ball in which an interpolated state counts as caught: its error is far below the rest.
constexpr double caught_when_interpolated = 0.9;

} // namespace

void declare_basin_search(parameters::Section &section) {
  using namespace parameters;
  section
      .integer("Most periods", "2000", Range{.lower = 1, .upper = 1e9}, "",
               "Forcing periods after which an initial condition is left unassigned.")
      .integer("Longest period", "16", Range{.lower = 1, .upper = 1000}, "",
               "Longest repetition of a motion that is looked for, in forcing periods.")
      .text("Excitation", "",
            "Excitation whose period is that of the forcing; empty when there is only one with a "
            "period.");
}

BasinSettings read_basin_search(const parameters::Values &section) {
  return {.attractors = {.most_periods = section.integer("Most periods"),
                         .longest_multiple = section.integer("Longest period")},
          .excitation = section.text("Excitation")};
}

BasinSearch::BasinSearch(System system, const BasinSettings &settings)
    : system_(std::move(system)),
      forced_(system_.model, system_.contacts, system_.integration,
              sweep_source(system_, settings.excitation, "An analysis of basins")),
      map_(forced_, orbit_accuracy(system_, forced_)), settings_(settings.attractors) {}

Vector BasinSearch::scaled_start(const model::InitialState &start) {
  motion::Trajectory &trajectory = forced_.trajectory();
  present_.resize(0); // in case none can start
  trajectory.start(0, start.displacement, start.velocity);
  periods_ = 0;
  present_ = seen_state();
  return present_;
}

// Of the trajectory, scaled, without what later motions do not see.
Vector BasinSearch::seen_state() {
  Vector state = forced_.trajectory().motion_state().physical.cwiseProduct(map_.scale());
  state(periodic::idle_memory(forced_.equations())).setZero();
  return state;
}

// A motion that stands there already goes on, which costs less than a start.
Vector BasinSearch::image(const Vector &scaled) {
  motion::Trajectory &trajectory = forced_.trajectory();
  if (present_.size() == 0 || scaled != present_) {
    trajectory.start({.time = 0, .physical = scaled.cwiseQuotient(map_.scale())});
    periods_ = 0;
  }
  present_.resize(0); // in case it fails on the way
  ++periods_;
  trajectory.advance(static_cast<double>(periods_) * forced_.period());
  present_ = seen_state();
  return present_;
}

// Shooting finds the motion with a section away from its contact changes; from there it goes to
// phase 0, where starts are given.
std::optional<FoundMotion> BasinSearch::find(const Vector &scaled, long multiple) {
  const Vector &scale = map_.scale();
  present_.resize(0); // the trajectory goes elsewhere
  try {
    const periodic::Orbit orbit = find_orbit(map_, multiple, scaled.cwiseQuotient(scale));
    if (!periodic::is_stable(orbit.multipliers(map_)))
      return {};
    Vector state = state_at_zero_phase(map_, orbit);
    Matrix by_state = map_.image({.phase = 0, .halves = 2 * orbit.multiple()}, state).by_state;
    const std::vector<Index> unseen = map_.idle(0, state);
    state(unseen).setZero();
    by_state(unseen, Eigen::all).setZero();
    return FoundMotion{.state = state.cwiseProduct(scale),
                       .multiple = orbit.multiple(),
                       .by_state =
                           scale.asDiagonal() * by_state * scale.cwiseInverse().asDiagonal()};
  } catch (const NumericalError &) { // nothing there that shooting could find
    return {};
  }
}

void BasinSearch::begin(const std::vector<model::InitialState> &starts) {
  lowest_ = highest_ = Vector();
  for (const model::InitialState &start : starts)
    try {
      const Vector state = scaled_start(start);
      lowest_ = lowest_.size() > 0 ? Vector(lowest_.cwiseMin(state)) : state;
      highest_ = highest_.size() > 0 ? Vector(highest_.cwiseMax(state)) : state;
    } catch (const InputError &) { // rigid sides overlap there
    }
  if (lowest_.size() == 0)
    throw NumericalError("no motion can begin at any of the starts");
  const double size = lowest_.cwiseAbs().cwiseMax(highest_.cwiseAbs()).norm();
  settings_.largest = size > 0 ? size : 1;
  interpolated_.reset();
  attractors_.emplace([this](const Vector &state) { return image(state); },
                      [this](const Vector &state, long multiple) { return find(state, multiple); },
                      settings_);
}

std::vector<std::size_t> BasinSearch::sort() {
  const auto &list = attractors_->list();
  std::vector<std::size_t> order(list.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return list[a].motion.state.norm() < list[b].motion.state.norm();
  });
  attractors_->choose(order);
  std::vector<std::size_t> places(order.size());
  for (std::size_t place = 0; place < order.size(); ++place)
    places[order[place]] = place;
  return places;
}

Decision BasinSearch::follow(const model::InitialState &start) {
  try {
    return attractors_->follow(scaled_start(start));
  } catch (const InputError &) { // rigid sides overlap there
    return {.outcome = periodic::Outcome::failed};
  }
}

void BasinSearch::interpolate(Index nodes) {
  if (states() != 2)
    throw std::logic_error("a map is interpolated between nodes of two states");
  std::array<periodic::NodeAxis, 2> axes;
  for (Index i = 0; i < 2; ++i) {
    const double middle = 0.5 * (lowest_[i] + highest_[i]);
    const double reach = 0.5 * reach_of_nodes * (highest_[i] - lowest_[i]);
    axes[static_cast<std::size_t>(i)] = {
        .first = middle - reach, .last = middle + reach, .count = nodes};
  }
  interpolated_.emplace([this](const Vector &state) { return image(state); }, axes);
}

Decision BasinSearch::approximate(const model::InitialState &start) {
  try {
    return attractors_->follow(
        scaled_start(start),
        [this](const Vector &state) -> Vector {
          const std::optional<Eigen::Vector2d> next = (*interpolated_)(state);
          return next ? Vector(*next) : image(state);
        },
        caught_when_interpolated);
  } catch (const InputError &) { // rigid sides overlap there
    return {.outcome = periodic::Outcome::failed};
  }
}

} // namespace vibroimpact::analyses
