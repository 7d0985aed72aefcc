#include "motion/episode/episode_time.h"

#include <cmath>
#include <stdexcept>

namespace vibroimpact::motion {

EpisodeTime::EpisodeTime(int begin_root, int end_root) : p_(begin_root), q_(end_root) {
  if (p_ < 1 || q_ < 1)
    throw std::invalid_argument("roots of the time are of order 1 or more");
}

// With n = p + q - 1: x is the sum of the Bernstein polynomials of degree n from the p-th on, 1 - x
// that of the others (Abramowitz and Stegun 1964, 26.5.24); no term is negative.
EpisodeTime::Point EpisodeTime::at(long double xi, long double rest) const {
  const int n = p_ + q_ - 1;
  if (n == 1)
    return {.x = xi, .rest = rest, .begin = 1, .end = 1, .slope_factor = 1};
  Point point{};
  long double binomial = 1;
  for (int j = 0; j <= n; ++j) {
    if (j < p_)
      point.end += binomial * std::pow(xi, j) * std::pow(rest, p_ - 1 - j);
    else
      point.begin += binomial * std::pow(xi, j - p_) * std::pow(rest, n - j);
    if (j == p_ - 1)
      point.slope_factor = binomial * static_cast<long double>(q_);
    binomial *= static_cast<long double>(n - j) / (j + 1);
  }
  point.x = std::pow(xi, p_) * point.begin;
  point.rest = std::pow(rest, q_) * point.end;
  return point;
}

long double EpisodeTime::inverse(long double x, long double rest) const {
  constexpr int halvings = 66; // the digits of xi
  if (p_ == 1 && q_ == 1)
    return x;
  long double low = 0;
  long double high = 1;
  for (int i = 0; i < halvings; ++i) {
    const long double middle = 0.5L * (low + high);
    const Point point = at(middle, 1 - middle);
    const bool above = x < rest ? point.x > x : point.rest < rest;
    (above ? high : low) = middle;
  }
  return 0.5L * (low + high);
}

// Where (p - 1) / xi = (q - 1) / (1 - xi).
double EpisodeTime::steepest() const {
  const int n = p_ + q_ - 2;
  const long double xi = n > 0 ? static_cast<long double>(p_ - 1) / n : 0;
  return static_cast<double>(at(xi, 1 - xi).slope_factor * std::pow(xi, p_ - 1) *
                             std::pow(1 - xi, q_ - 1));
}

} // namespace vibroimpact::motion
