#include "analyses/isolators/isolator_averaging.h"

#include "common/scalar.h"
#include "common/zero.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

using std::numbers::pi;

double contact_share(double z) {
  return 1 - 2 / pi * (std::asin(z) + z * std::sqrt((1 - z) * (1 + z)));
}

double contact_share_slope(double z) { return -4 / pi * std::sqrt((1 - z) * (1 + z)); }

/// Zero of a function between two points of opposite signs.
/// Zeros of a function on a grid, pairs between neighbouring points included where the function
/// comes nearest to zero.
std::vector<double> zeros_on(const std::vector<double> &grid,
                             const std::function<double(double)> &function) {
  std::vector<double> values, zeros;
  for (const double x : grid)
    values.push_back(function(x));
  for (std::size_t i = 0; i + 1 < grid.size(); ++i)
    if (values[i] * values[i + 1] < 0)
      zeros.push_back(zero_between(function, grid[i], grid[i + 1]));
  for (std::size_t i = 1; i + 1 < grid.size(); ++i) {
    const double sign = values[i] > 0 ? 1 : -1;
    if (sign * values[i - 1] < sign * values[i] || sign * values[i + 1] < sign * values[i] ||
        sign * values[i - 1] <= 0 || sign * values[i + 1] <= 0)
      continue;
    const auto [at, nearest] =
        minimum_between([&](double x) { return sign * function(x); }, grid[i - 1], grid[i + 1]);
    if (nearest < 0) {
      zeros.push_back(zero_between(function, grid[i - 1], at));
      zeros.push_back(zero_between(function, at, grid[i + 1]));
    }
  }
  return zeros;
}

} // namespace

struct AveragedResponse::Terms {
  double stiffness = 0, damping = 0;             ///< P, Q
  double stiffness_slope = 0, damping_slope = 0; ///< P', Q'
};

AveragedResponse::Terms AveragedResponse::terms(double z) const {
  const double share = contact_share(z), slope = contact_share_slope(z);
  return {.stiffness = 1 + stop_.stiffness * share,
          .damping = damping_.isolator + damping_.stop * share,
          .stiffness_slope = stop_.stiffness * slope,
          .damping_slope = damping_.stop * slope};
}

// E(0) < 0, and E grows with z while P > 2 Q^2.
AveragedResponse::AveragedResponse(const IsolatorDamping &damping, const StopChoice &stop)
    : damping_(damping), stop_(stop) {
  if (discriminant(1) > 0)
    least_z_ = zero_between([this](double z) { return discriminant(z); }, 0, 1);
}

double AveragedResponse::discriminant(double z) const {
  const Terms at = terms(z);
  return square(stop_.force * z) - 4 * square(at.damping) * (at.stiffness - square(at.damping));
}

std::array<double, 2> AveragedResponse::ratios(double z) const {
  const Terms at = terms(z);
  const double middle = at.stiffness - 2 * square(at.damping);
  const double root = std::sqrt(std::max(0.0, discriminant(z)));
  return {std::sqrt(middle - root), std::sqrt(middle + root)};
}

// sqrt(E) d(lambda^2)/dz = (P' - 4 Q Q') sqrt(E) + side E'/2: finite where the sides meet.
double AveragedResponse::turning(double z, double side) const {
  const Terms at = terms(z);
  const double q = at.damping, q_slope = at.damping_slope;
  const double e_slope = 2 * square(stop_.force) * z -
                         8 * q * q_slope * (at.stiffness - square(q)) -
                         4 * square(q) * (at.stiffness_slope - 2 * q * q_slope);
  return (at.stiffness_slope - 4 * q * q_slope) * std::sqrt(std::max(0.0, discriminant(z))) +
         side * e_slope / 2;
}

void AveragedResponse::add_folds(double side, std::vector<AveragedPoint> &folds) const {
  constexpr int points = 300; // dense at both ends: folds come near the peak and the first touch
  const double widest = std::acos(least_z_);
  std::vector<double> grid;
  for (int i = 0; i <= points; ++i)
    grid.push_back(std::cos(widest * (1 + std::cos(pi * i / points)) / 2));
  for (const double z : zeros_on(grid, [&](double at) { return turning(at, side); })) {
    const double ratio = ratios(z)[side > 0 ? 1 : 0];
    if (std::isfinite(ratio))
      folds.push_back({.z = z, .ratio = ratio});
  }
}

std::vector<AveragedPoint> AveragedResponse::folds() const {
  std::vector<AveragedPoint> folds;
  if (reaches_stop())
    for (const double side : {-1.0, 1.0})
      add_folds(side, folds);
  std::sort(folds.begin(), folds.end(), [](const AveragedPoint &one, const AveragedPoint &other) {
    return one.ratio < other.ratio;
  });
  return folds;
}

// Without contact the largest amplitude is f/(2 zeta_0 sqrt(1 - zeta_0^2)).
ResponsePeak AveragedResponse::peak() const {
  if (reaches_stop())
    return {.amplitude = 1 / least_z_, .ratio = ratios(least_z_)[0]};
  const double zeta = damping_.isolator;
  return {.amplitude = stop_.force / (2 * zeta * std::sqrt(1 - square(zeta))),
          .ratio = std::sqrt(1 - 2 * square(zeta))};
}

double stiffness_for_peak(double force, double amplitude, const IsolatorDamping &damping) {
  const double z = 1 / amplitude, share = contact_share(z);
  const double q = damping.isolator + damping.stop * share;
  return (square(force * z / (2 * q)) - 1 + square(q)) / share;
}

double stiffness_of_first_jump(double force, const IsolatorDamping &damping) {
  const auto folds = [&](double stiffness) {
    return !AveragedResponse(damping, {.stiffness = stiffness, .force = force}).folds().empty();
  };
  constexpr double most = 1e4, factor = 1.1, accuracy = 1e-12;
  double without = 0, with = 0.01;
  while (!folds(with)) {
    without = with;
    with *= factor;
    if (with > most)
      return std::numeric_limits<double>::quiet_NaN();
  }
  while (with - without > accuracy * with) {
    const double middle = (without + with) / 2;
    (folds(middle) ? with : without) = middle;
  }
  return without;
}

} // namespace vibroimpact::analyses
