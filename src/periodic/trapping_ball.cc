#include "periodic/trapping_ball.h"

#include "common/error.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace vibroimpact::periodic {

namespace {

constexpr double required_share = 0.3; ///< of 1 - |mu|; linear maps have 0.5
constexpr double growth = 1.15;        ///< from one tested sphere to the next
constexpr double shrinkage = 0.25;     ///< while even the first sphere does not contract
constexpr double first_share = 1e-3;   ///< of the largest radius, where testing begins
constexpr double least_share = 1e-10;  ///< below which differences are rounding
/// Of the last sphere that was tested. In the plane its points are an angle of 0.1 apart; in more
/// dimensions they are a sample.
constexpr double safe_share_plane = 0.8, safe_share = 0.5;
constexpr int most_doublings = 60;

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

Matrix discrete_lyapunov(const Matrix &a) {
  Matrix sum = Matrix::Identity(a.rows(), a.cols());
  Matrix power = a;
  // The sum of the first 2^k terms; what is left is below the square of the last power.
  for (int k = 0; k < most_doublings && power.norm() > 1e-20; ++k) {
    sum += (power.transpose() * sum * power).eval();
    power = (power * power).eval();
  }
  return sum;
}

TrappingBall::TrappingBall(const StateMap &map, Vector fixed_point, const Matrix &by_state,
                           double largest, Index points)
    : fixed_point_(std::move(fixed_point)) {
  const double multiplier = by_state.eigenvalues().cwiseAbs().maxCoeff();
  if (!(multiplier < 1))
    throw std::logic_error("a trapping ball needs a stable fixed point");
  contraction_ = 1 - required_share * (1 - multiplier);
  root_ = discrete_lyapunov(by_state / (0.5 * (1 + multiplier))).llt().matrixL();
  const Index size = fixed_point_.size();
  const Index count = points > 0 ? points : std::max<Index>(64, 8 * size);
  // y = L^-T u has |y|_S = |u|.
  const Matrix directions =
      root_.transpose().triangularView<Eigen::Upper>().solve(unit_vectors(size, count));
  // |y|_S <= |L| |y|.
  radius_ =
      reach(map, directions, root_.norm() * largest) * (size == 2 ? safe_share_plane : safe_share);
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
