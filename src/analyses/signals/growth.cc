#include "analyses/signals/growth.h"

#include "common/scalar.h"

#include <cmath>
#include <numeric>

namespace vibroimpact::analyses {

namespace {

double mean_rate(const std::vector<double> &logarithms, const std::vector<double> &durations,
                 std::size_t first, std::size_t last) {
  const auto from = static_cast<std::ptrdiff_t>(first);
  const auto to = static_cast<std::ptrdiff_t>(last);
  return std::accumulate(logarithms.begin() + from, logarithms.begin() + to, 0.0) /
         std::accumulate(durations.begin() + from, durations.begin() + to, 0.0);
}
} // namespace

void Growth::add(double duration, double logarithm) {
  durations_.push_back(duration);
  logarithms_.push_back(logarithm);
}

std::size_t Growth::first() const {
  return static_cast<std::size_t>(
      std::floor(discarded_share_ * static_cast<double>(logarithms_.size())));
}

double Growth::exponent() const {
  if (logarithms_.empty())
    return nan;
  return mean_rate(logarithms_, durations_, first(), logarithms_.size());
}

std::vector<double> Growth::running_exponent() const {
  std::vector<double> running;
  double logarithm = 0, duration = 0;
  for (std::size_t i = first(); i < logarithms_.size(); ++i) {
    logarithm += logarithms_[i];
    duration += durations_[i];
    running.push_back(logarithm / duration);
  }
  return running;
}

std::vector<double> Growth::elapsed() const {
  std::vector<double> ends(durations_.size());
  std::partial_sum(durations_.begin(), durations_.end(), ends.begin());
  ends.erase(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(first()));
  return ends;
}

double Growth::standard_error(std::size_t blocks) const {
  const std::size_t length = (logarithms_.size() - first()) / blocks;
  if (length < 2)
    return nan;
  // What does not fill a block is left out at the start.
  const std::size_t start = logarithms_.size() - length * blocks;
  const double mean = mean_rate(logarithms_, durations_, start, logarithms_.size());
  double squares = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t from = start + b * length;
    const double deviation = mean_rate(logarithms_, durations_, from, from + length) - mean;
    squares += deviation * deviation;
  }
  const auto count = static_cast<double>(blocks);
  return std::sqrt(squares / (count - 1) / count);
}

} // namespace vibroimpact::analyses
