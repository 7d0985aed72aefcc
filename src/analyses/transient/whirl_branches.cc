#include "analyses/transient/whirl_branches.h"

#include "common/zero.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace vibroimpact::analyses {

namespace {

// At rest the shapes of a round shaft in two planes are any two; a circle resembles each by half.
constexpr double alike = 0.45;
constexpr int most_divisions = 10;

bool same_frequency(const WhirlState &a, const WhirlState &b) {
  constexpr double rounding = 1e-6;
  return std::abs(a.eigenvalue.imag() - b.eigenvalue.imag()) <= rounding * a.eigenvalue.imag();
}

} // namespace

WhirlBranches::WhirlBranches(const model::WhirlingSystem &system, std::vector<double> speeds,
                             std::size_t modes)
    : system_(system), speeds_(std::move(speeds)) {
  const std::vector<WhirlState> first = vibrations(speeds_.front());
  std::size_t count = std::min(modes, first.size());
  while (count > 0 && count < first.size() && same_frequency(first[count - 1], first[count]))
    ++count;
  WhirlStates states(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(count));
  states_.push_back(states);
  for (std::size_t k = 1; k < speeds_.size(); ++k)
    states_.push_back(follow(speeds_[k - 1], states_.back(), speeds_[k], most_divisions));
  sort_modes();
}

// By the frequencies at the second speed: at the first one those of a pair may be the same.
void WhirlBranches::sort_modes() {
  const auto frequency = [&](std::size_t mode) {
    const auto &state = states_[1][mode];
    return state ? state->eigenvalue.imag() : std::numeric_limits<double>::infinity();
  };
  std::vector<std::size_t> order(modes());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return frequency(a) < frequency(b); });
  for (WhirlStates &states : states_) {
    WhirlStates sorted;
    for (const std::size_t mode : order)
      sorted.push_back(states[mode]);
    states = std::move(sorted);
  }
}

std::vector<WhirlState> WhirlBranches::vibrations(double speed) const {
  const model::DampedModes modes = system_.at(speed);
  const double rounding = 1e-9 * modes.eigenvalues.cwiseAbs().maxCoeff();
  std::vector<WhirlState> list;
  for (Index j = 0; j < modes.eigenvalues.size(); ++j) {
    if (modes.eigenvalues[j].imag() <= rounding)
      continue;
    const ComplexVector shape = modes.shapes.col(j);
    const double mass = system_.model().mass().dot(shape.cwiseAbs2());
    list.push_back({.eigenvalue = modes.eigenvalues[j], .shape = shape / std::sqrt(mass)});
  }
  std::stable_sort(list.begin(), list.end(), [](const WhirlState &a, const WhirlState &b) {
    return a.eigenvalue.imag() < b.eigenvalue.imag();
  });
  return list;
}

// 1: the same shape but for size and phase, 0: orthogonal.
double WhirlBranches::resemblance(const WhirlState &a, const WhirlState &b) const {
  const Vector &mass = system_.model().mass();
  return std::norm(a.shape.dot(mass.cast<std::complex<double>>().cwiseProduct(b.shape)));
}

// Pairs of modes and vibrations by falling resemblance; the least of them beside.
std::pair<WhirlStates, double> WhirlBranches::matched(const WhirlStates &states,
                                                      double speed) const {
  const std::vector<WhirlState> candidates = vibrations(speed);
  struct Pair {
    double resemblance;
    std::size_t mode, candidate;
  };
  std::vector<Pair> pairs;
  for (std::size_t j = 0; j < states.size(); ++j)
    for (std::size_t k = 0; states[j] && k < candidates.size(); ++k)
      pairs.push_back({resemblance(*states[j], candidates[k]), j, k});
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair &a, const Pair &b) { return a.resemblance > b.resemblance; });
  WhirlStates next(states.size());
  std::vector<bool> taken(candidates.size(), false);
  double least = 1;
  for (const Pair &pair : pairs)
    if (!next[pair.mode] && !taken[pair.candidate]) {
      next[pair.mode] = candidates[pair.candidate];
      taken[pair.candidate] = true;
      least = std::min(least, pair.resemblance);
    }
  return {next, least};
}

WhirlStates WhirlBranches::follow(double from, const WhirlStates &states, double to,
                                  int divisions) const {
  const auto [next, least] = matched(states, to);
  if (least >= alike || divisions == 0)
    return next;
  const double middle = (from + to) / 2;
  return follow(middle, follow(from, states, middle, divisions - 1), to, divisions - 1);
}

// The vibration that resembles both neighbours most.
WhirlState WhirlBranches::between(double speed, const WhirlState &a, const WhirlState &b) const {
  const std::vector<WhirlState> candidates = vibrations(speed);
  const auto likeness = [&](const WhirlState &state) {
    return resemblance(a, state) + resemblance(b, state);
  };
  return *std::max_element(
      candidates.begin(), candidates.end(),
      [&](const WhirlState &x, const WhirlState &y) { return likeness(x) < likeness(y); });
}

// Speeds at which the measure is exactly zero are passed over: the signs on both sides count.
std::vector<WhirlSpeed> WhirlBranches::zeros(const Measure &measure) const {
  std::vector<WhirlSpeed> list;
  for (std::size_t j = 0; j < modes(); ++j) {
    std::optional<std::size_t> last;
    for (std::size_t k = 0; k < speeds_.size(); ++k) {
      const auto &now = state(k, j);
      if (!now)
        last.reset();
      if (!now || measure(speeds_[k], *now) == 0)
        continue;
      const std::optional<std::size_t> before = std::exchange(last, k);
      if (!before)
        continue;
      const WhirlState &a = *state(*before, j);
      if ((measure(speeds_[*before], a) > 0) == (measure(speeds_[k], *now) > 0))
        continue;
      const double speed =
          zero_between([&](double at) { return measure(at, between(at, a, *now)); },
                       speeds_[*before], speeds_[k]);
      list.push_back({speed, j, between(speed, a, *now)});
    }
  }
  return list;
}

std::vector<WhirlSpeed> WhirlBranches::critical(double multiple) const {
  return zeros([&](double speed, const WhirlState &state) {
    return state.eigenvalue.imag() - multiple * std::abs(speed);
  });
}

std::vector<WhirlSpeed> WhirlBranches::thresholds() const {
  constexpr double rounding = 1e-12;
  return zeros([](double /*speed*/, const WhirlState &state) {
    const double rate = state.eigenvalue.real();
    return std::abs(rate) > rounding * std::abs(state.eigenvalue) ? rate : 0;
  });
}

} // namespace vibroimpact::analyses
