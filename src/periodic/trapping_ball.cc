#include "periodic/trapping_ball.h"

#include "common/error.h"

#include <cmath>
#include <numbers>
#include <random>

namespace vibroimpact::periodic {

namespace {

constexpr double required_share = 0.3; ///< of 1 - |mu|; linear maps have 0.5
constexpr double growth = 1.15;        ///< from one tested sphere to the next
constexpr double shrinkage = 0.25;     ///< while even the first sphere does not contract
constexpr double first_share = 1e-3;   ///< of the largest radius, where testing begins
constexpr double least_share = 1e-10;  ///< below which differences are rounding
/// Of the last sphere that was tested. In the plane its points are an angle of 0.1 apart; in more
/// dimensions they are a sample. Found by trial, no bound: between the points the map may do
/// anything. With these shares no cell of 80 x 80 starts of a double well, whose basins are known,
/// was decided wrongly (tests/periodic/attractors.cc).
constexpr double safe_share_plane = 0.8, safe_share = 0.5;

// Unit vectors as columns: evenly in the plane, else a fixed sample of all directions.
Matrix unit_vectors(Index size, Index count) {
  Matrix directions(size, count);
  if (size == 2) {
    for (Index k = 0; k < count; ++k) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
      directions.col(k) << std::cos(angle), std::sin(angle);
    }
    return directions;
  }
  std::mt19937_64 random(20); // NOLINT(cert-msc51-cpp): the same sample in every run
  std::normal_distribution<double> normal;
  for (Index k = 0; k < count; ++k) {
    for (Index j = 0; j < size; ++j)
      directions(j, k) = normal(random);
    directions.col(k).normalize();
  }
  return directions;
}

} // namespace

TrappingBall::TrappingBall(const StateMap &map, Vector fixed_point, const Matrix &by_state,
                           double largest, Index points)
    : fixed_point_(std::move(fixed_point)), norm_(by_state, spectral_radius(by_state)),
      contraction_(1 - required_share * (1 - norm_.multiplier())) {
  const Index size = fixed_point_.size();
  const Index count = points > 0 ? points : std::max<Index>(64, 8 * size);
  const Matrix &root = norm_.root();
  const Matrix directions =
      root.transpose().triangularView<Eigen::Upper>().solve(unit_vectors(size, count));
  // |y|_S <= |L| |y|.
  radius_ =
      reach(map, directions, root.norm() * largest) * (size == 2 ? safe_share_plane : safe_share);
}

bool TrappingBall::contracts(const StateMap &map, const Matrix &directions, double radius) const {
  try {
    for (const auto &direction : directions.colwise())
      if (!(distance(map(fixed_point_ + radius * direction)) <= contraction_ * radius))
        return false;
  } catch (const NumericalError &) { // no motion starts there
    return false;
  }
  return true;
}

double TrappingBall::reach(const StateMap &map, const Matrix &directions, double largest) const {
  double radius = first_share * largest;
  while (!contracts(map, directions, radius)) {
    radius *= shrinkage;
    if (radius < least_share * largest)
      return 0;
  }
  while (radius < largest && contracts(map, directions, growth * radius))
    radius *= growth;
  return radius;
}

} // namespace vibroimpact::periodic
