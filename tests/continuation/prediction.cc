// The prediction of a curve's next point from the last two.
#include "continuation/piece.h"

#include <gtest/gtest.h>

#include <boost/math/tools/roots.hpp>

#include <cmath>

namespace vibroimpact::continuation {

namespace {

// A helix and its tangent of length 1.
Vector helix(double turn) { return Eigen::Vector3d(std::cos(turn), std::sin(turn), 0.5 * turn); }
Vector tangent(double turn) {
  return Eigen::Vector3d(-std::sin(turn), std::cos(turn), 0.5).normalized();
}

// The point at the distance `step` along the tangent at turn 0.
Vector point_ahead(double step) {
  const auto distance = [&](double turn) {
    return std::make_pair(tangent(0).dot(helix(turn) - helix(0)) - step,
                          tangent(0).dot(Eigen::Vector3d(-std::sin(turn), std::cos(turn), 0.5)));
  };
  return helix(boost::math::tools::newton_raphson_iterate(distance, step, 0.0, 2 * step, 50));
}

double error_of_step(double step) {
  const Hermite path(helix(-step), tangent(-step), helix(0), tangent(0));
  return (path.beyond(step) - point_ahead(step)).norm();
}

} // namespace

TEST(PredictionTest, CubicIsOffByTheFourthPowerOfTheStep) {
  for (const double step : {0.2, 0.1, 0.05})
    EXPECT_NEAR(std::log2(error_of_step(step) / error_of_step(step / 2)), 4, 0.2) << step;
  EXPECT_LT(error_of_step(0.1), 1e-5); // the tangent is off by 4e-3
}

TEST(PredictionTest, LiesAtTheStepAlongTheTangent) {
  const Hermite path(helix(-0.1), tangent(-0.1), helix(0), tangent(0));
  for (const double step : {0.02, 0.1, 0.2})
    EXPECT_NEAR(tangent(0).dot(path.beyond(step) - helix(0)), step, 1e-15) << step;
}

TEST(PredictionTest, IsTheTangentWhereTheCubicIsFarFromIt) {
  const Eigen::Vector2d begin(0, 0), end(1, 0), along(1, 0), bent = Eigen::Vector2d(1, 0.9);
  const Hermite path(begin, bent.normalized(), end, along);
  EXPECT_LT((path.beyond(1) - Eigen::Vector2d(2, 0)).norm(), 1e-15);
}

} // namespace vibroimpact::continuation
