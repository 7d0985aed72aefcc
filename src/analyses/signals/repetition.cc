#include "analyses/signals/repetition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

StroboscopicPoints::StroboscopicPoints(const std::vector<Vector> &states, const Vector &scale,
                                       const std::vector<Index> &angles)
    : turn_(Vector::Zero(scale.size())) {
  for (const Vector &state : states)
    points_.emplace_back(state.cwiseQuotient(scale));
  for (const Index angle : angles)
    turn_[angle] = 2 * std::numbers::pi / scale[angle];
}

double StroboscopicPoints::difference(std::size_t n, std::size_t k) const {
  double largest = 0;
  for (Index j = 0; j < turn_.size(); ++j) {
    const double d = points_[n + k][j] - points_[n][j];
    largest = std::max(largest, std::abs(turn_[j] > 0 ? std::remainder(d, turn_[j]) : d));
  }
  return largest;
}

double StroboscopicPoints::largest_difference(std::size_t k, std::size_t first,
                                              std::size_t last) const {
  double largest = 0;
  for (std::size_t n = first; n + k <= last; ++n)
    largest = std::max(largest, difference(n, k));
  return largest;
}

Repetition find_repetition(const StroboscopicPoints &points, long longest, double tolerance) {
  if (points.size() < 2)
    return {};
  const std::size_t last = points.size() - 1;
  const auto searched = std::min(longest, static_cast<long>(last / 2));
  Repetition best{.difference = std::numeric_limits<double>::infinity(), .searched = searched};
  for (long k = 1; k <= searched; ++k) {
    const double difference = points.largest_difference(static_cast<std::size_t>(k), 0, last);
    if (difference < tolerance)
      return {.multiple = k, .difference = difference, .searched = searched};
    best.difference = std::min(best.difference, difference);
  }
  return best;
}

Approach find_spiral(const StroboscopicPoints &points, long k) {
  const std::size_t last = points.size() - 1;
  const auto turn = static_cast<std::size_t>(k);
  for (std::size_t j = 1; j < turn; ++j) {
    const double first = points.largest_difference(j, 0, turn - 1 + j);
    const double end = points.largest_difference(j, last - j - (turn - 1), last);
    if (!(end < 0.95 * first))
      continue;
    const double rate = std::pow(end / first, 1.0 / static_cast<double>(last - j - (turn - 1)));
    const double factor = std::pow(rate, static_cast<double>(j));
    return {.multiple = static_cast<long>(j),
            .rate = rate,
            .remaining = points.difference(last - j, j) * factor / (1 - factor)};
  }
  return {};
}

Approach find_approach(const StroboscopicPoints &points, long longest) {
  if (points.size() < 4)
    return {};
  const std::size_t last = points.size() - 1;
  for (long multiple = 1; multiple <= std::min(longest, static_cast<long>(last / 6)); ++multiple) {
    const auto k = static_cast<std::size_t>(multiple);
    std::array<double, 3> third{};
    for (std::size_t i = 0; i < 3; ++i)
      third[i] = points.largest_difference(k, i * last / 3, (i + 1) * last / 3);
    const double first = third[1] / third[0];
    const double second = third[2] / third[1];
    if (first < 0.9 && second < 0.9 && std::log(second) < 0.5 * std::log(first)) {
      const double rate = std::pow(second, 3.0 / static_cast<double>(last));
      const double factor = std::pow(rate, static_cast<double>(multiple));
      return {.multiple = multiple,
              .rate = rate,
              .remaining = points.difference(last - k, k) * factor / (1 - factor)};
    }
  }
  return {};
}

} // namespace vibroimpact::analyses
