#include "analyses/design/population.h"

#include "common/uniform_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vibroimpact::analyses {

namespace {

constexpr double least_factor = 0.1, largest_factor = 0.9; // F
constexpr double crossover = 0.7;                          // C
constexpr double share_of_the_best = 0.2;
constexpr std::size_t least_members = 4; // x, a, b and one of the best

/// 0 where it meets the constraints or failed.
double missed(const TrialValue &value) { return value.failed ? 0 : std::max(0.0, value.excess); }

bool better_in_goals(const TrialValue &a, const TrialValue &b) {
  bool better = false;
  for (std::size_t g = 0; g < a.goals.size(); ++g) {
    if (a.goals[g] > b.goals[g])
      return false;
    better = better || a.goals[g] < b.goals[g];
  }
  return better;
}

/// Distance of each value's neighbours along each goal, relative to that of the ends, which get
/// infinity.
std::vector<double> crowding(const std::vector<TrialValue> &values) {
  std::vector<double> distance(values.size(), 0);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t g = 0; g < values.front().goals.size(); ++g) {
    const auto goal = [&](std::size_t place) { return values[order[place]].goals[g]; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return values[a].goals[g] < values[b].goals[g];
    });
    const double range = goal(order.size() - 1) - goal(0);
    distance[order.front()] = distance[order.back()] = std::numeric_limits<double>::infinity();
    for (std::size_t place = 1; range > 0 && place + 1 < order.size(); ++place)
      distance[order[place]] += (goal(place + 1) - goal(place - 1)) / range;
  }
  return distance;
}

} // namespace

bool dominates(const TrialValue &a, const TrialValue &b) {
  if (a.failed || b.failed)
    return b.failed && !a.failed;
  if (missed(a) > 0 || missed(b) > 0)
    return missed(a) < missed(b);
  return better_in_goals(a, b);
}

std::vector<std::size_t> not_dominated(const std::vector<TrialValue> &values) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!values[i].failed &&
        std::none_of(values.begin(), values.end(),
                     [&](const TrialValue &other) { return dominates(other, values[i]); }))
      front.push_back(i);
  return front;
}

Population::Population(Settings settings) : settings_(std::move(settings)) {
  settings_.size = std::max(settings_.size, least_members);
}

// Trial t lies in another of N equal parts of each coordinate than all others.
Vector Population::first_trial(std::size_t trial) const {
  if (trial == 0)
    return settings_.start;
  Vector coordinates(settings_.start.size());
  UniformNumbers own({settings_.seed, settings_.number, trial});
  for (Index j = 0; j < coordinates.size(); ++j) {
    UniformNumbers of_key({settings_.seed, settings_.number, 0, static_cast<std::size_t>(j)});
    std::vector<std::size_t> part(settings_.size);
    std::iota(part.begin(), part.end(), std::size_t{0});
    for (std::size_t i = part.size() - 1; i > 0; --i)
      std::swap(part[i], part[of_key.below(i + 1)]);
    coordinates[j] =
        (static_cast<double>(part[trial]) + own.next()) / static_cast<double>(settings_.size);
  }
  return coordinates;
}

std::vector<std::size_t> Population::best() const {
  std::vector<std::size_t> order(members_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (members_.front().value.goals.size() > 1) {
    std::vector<TrialValue> values;
    for (const Member &member : members_)
      values.push_back(member.value);
    const std::vector<std::size_t> front = not_dominated(values);
    return front.empty() ? order : front;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return dominates(members_[a].value, members_[b].value);
  });
  const double share = share_of_the_best * static_cast<double>(order.size());
  order.resize(std::max<std::size_t>(2, static_cast<std::size_t>(share)));
  return order;
}

Vector Population::propose(std::size_t trial) const {
  if (trial < settings_.size)
    return first_trial(trial);
  UniformNumbers random({settings_.seed, settings_.number, trial});
  const Index n = settings_.start.size();
  if (members_.size() < least_members)
    return Vector::NullaryExpr(n, [&random](Index) { return random.next(); });
  const std::size_t i = trial % members_.size();
  const std::vector<std::size_t> good = best();
  const Vector &x = members_[i].coordinates;
  const Vector &p = members_[good[random.below(good.size())]].coordinates;
  std::size_t a = i, b = i;
  while (a == i)
    a = random.below(members_.size());
  while (b == i || b == a)
    b = random.below(members_.size());
  const double factor = least_factor + (largest_factor - least_factor) * random.next();
  const Vector mutant =
      x + factor * (p - x) + factor * (members_[a].coordinates - members_[b].coordinates);
  Vector coordinates = x;
  const Index surely = static_cast<Index>(random.below(static_cast<std::size_t>(n)));
  for (Index j = 0; j < n; ++j)
    if (random.next() < crossover || j == surely)
      coordinates[j] = std::clamp(mutant[j], 0.0, 1.0);
  return coordinates;
}

void Population::take_in(std::size_t trial, Vector coordinates, TrialValue value) {
  const bool single = value.goals.size() < 2;
  if (members_.size() < settings_.size || !single) {
    members_.push_back({std::move(coordinates), std::move(value)});
    if (members_.size() > settings_.size)
      remove_the_worst();
    return;
  }
  Member &target = members_[trial % members_.size()];
  if (!dominates(target.value, value))
    target = {std::move(coordinates), std::move(value)};
}

// Of the last front: those that are left when the front that nothing dominates is taken away, again
// and again.
void Population::remove_the_worst() {
  std::vector<std::size_t> left(members_.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<std::size_t> last = left;
  std::vector<TrialValue> values;
  while (!left.empty()) {
    values.clear();
    for (const std::size_t member : left)
      values.push_back(members_[member].value);
    last = left;
    const std::vector<std::size_t> front = not_dominated(values);
    if (front.empty() || front.size() == left.size())
      break;
    for (auto place = front.rbegin(); place != front.rend(); ++place)
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(*place));
  }
  const std::vector<double> distance = crowding(values);
  const auto worst = std::min_element(distance.begin(), distance.end()) - distance.begin();
  members_.erase(members_.begin() +
                 static_cast<std::ptrdiff_t>(last[static_cast<std::size_t>(worst)]));
}

std::vector<Vector> Population::coordinates() const {
  std::vector<Vector> all;
  for (const Member &member : members_)
    all.push_back(member.coordinates);
  return all;
}

bool Population::converged() const {
  if (members_.size() < settings_.size || members_.front().value.goals.size() > 1)
    return false;
  Vector lowest = members_.front().coordinates, highest = lowest;
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const Member &member : members_) {
    lowest = lowest.cwiseMin(member.coordinates);
    highest = highest.cwiseMax(member.coordinates);
    if (member.value.failed || missed(member.value) > 0)
      return false;
    least = std::min(least, member.value.goals[0]);
    largest = std::max(largest, member.value.goals[0]);
  }
  return (highest - lowest).maxCoeff() <= settings_.tolerance ||
         (settings_.goal_tolerance > 0 &&
          largest - least <= settings_.goal_tolerance * std::abs(least));
}

} // namespace vibroimpact::analyses
