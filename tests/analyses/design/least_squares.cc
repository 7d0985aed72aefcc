// Least squares with known minima, inside and at bounds.
#include "analyses/design/least_squares.h"

#include "common/error.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace least_squares_tests {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// y = a exp(-b x) + c at x = 0, 0.2 ... from a = 2, b = 1.3, c = 0.4.
struct Decay {
  Vector x = Vector::LinSpaced(20, 0, 3.8);
  Vector y = at(Eigen::Vector3d(2, 1.3, 0.4));

  Vector at(const Vector &p) const { return p[0] * (-p[1] * x.array()).exp() + p[2]; }
  LeastSquaresProblem problem() const {
    return {.lower = Vector::Constant(3, -infinity),
            .upper = Vector::Constant(3, infinity),
            .start = Eigen::Vector3d(0.5, 0.3, 0),
            .residuals = [this](const Vector &p) { return Vector(at(p) - y); },
            .jacobian =
                [this](const Vector &p) {
                  const Vector e = (-p[1] * x.array()).exp();
                  Matrix j(x.size(), 3);
                  j << e, -p[0] * x.cwiseProduct(e), Vector::Ones(x.size());
                  return j;
                },
            .tolerance = 1e-10,
            .most_steps = 200};
  }
};

TEST(LeastSquaresTest, FindsWhatTheDataWereMadeWith) {
  const Decay decay;
  LeastSquaresProblem problem = decay.problem();
  Vector last;
  problem.residuals = [&](const Vector &p) {
    last = p;
    return Vector(decay.at(p) - decay.y);
  };
  const SearchEnd end = least_squares(problem);
  EXPECT_TRUE(end == SearchEnd::tolerance || end == SearchEnd::objective_tolerance);
  EXPECT_LT((last - Eigen::Vector3d(2, 1.3, 0.4)).norm(), 1e-6);
}

// At a bound the free part of the gradient vanishes and the bound's part points outwards.
TEST(LeastSquaresTest, AtABoundTheGradientPointsOutwards) {
  const Decay decay;
  LeastSquaresProblem problem = decay.problem();
  problem.lower = Vector::Zero(3);
  problem.upper = Eigen::Vector3d(5, 5, 0.35);
  Vector best;
  double least = infinity;
  problem.residuals = [&](const Vector &p) {
    const Vector r = decay.at(p) - decay.y;
    if (r.squaredNorm() < least) {
      least = r.squaredNorm();
      best = p;
    }
    EXPECT_TRUE((p.array() >= problem.lower.array()).all());
    EXPECT_TRUE((p.array() <= problem.upper.array()).all());
    return r;
  };
  least_squares(problem);
  EXPECT_NEAR(best[2], 0.35, 1e-9);
  const Vector gradient = problem.jacobian(best).transpose() * (decay.at(best) - decay.y);
  EXPECT_LT(gradient.head(2).norm(), 1e-5);
  EXPECT_LT(gradient[2], -1e-3);
}

TEST(LeastSquaresTest, AFreeDirectionDoesNoHarm) {
  // Only b / a counts.
  const Vector x = Vector::LinSpaced(10, 0, 2), y = (-1.3 * x.array()).exp();
  LeastSquaresProblem problem{.lower = Eigen::Vector2d(0.1, 0.1),
                              .upper = Eigen::Vector2d(5, 5),
                              .start = Eigen::Vector2d(1, 1),
                              .residuals = {},
                              .jacobian = {},
                              .tolerance = 1e-10,
                              .most_steps = 200};
  Vector last;
  problem.residuals = [&](const Vector &p) {
    last = p;
    return Vector((-p[1] / p[0] * x.array()).exp().matrix() - y);
  };
  problem.jacobian = [&](const Vector &p) {
    const Vector e = x.array() * (-p[1] / p[0] * x.array()).exp();
    Matrix j(10, 2);
    j << p[1] / (p[0] * p[0]) * e, -e / p[0];
    return j;
  };
  least_squares(problem);
  EXPECT_NEAR(last[1] / last[0], 1.3, 1e-5);
}

// Only b / a counts, and derivatives are differences: their error makes the Jacobian regular, and a
// Gauss-Newton step goes some 1e4 along the free direction. A negative a has no residuals.
TEST(LeastSquaresTest, ErrorsOfDerivativesMoveNothingAlongAFreeDirection) {
  const Vector x = Vector::LinSpaced(10, 0, 2);
  Vector y = (-1.3 * x.array()).exp();
  y[3] += 0.01;
  LeastSquaresProblem problem{.lower = Vector::Constant(2, -infinity),
                              .upper = Vector::Constant(2, infinity),
                              .start = Eigen::Vector2d(1, 0.2),
                              .residuals = {},
                              .jacobian = {},
                              .tolerance = 1e-8,
                              .most_steps = 100};
  Vector last;
  problem.residuals = [&](const Vector &p) {
    if (p[0] <= 0)
      throw NumericalError("no mass");
    last = p;
    return Vector(1000 * ((-p[1] / p[0] * x.array()).exp().matrix() - y));
  };
  problem.jacobian = [&](const Vector &p) {
    const Vector here = problem.residuals(p);
    Matrix j(10, 2);
    for (Index k = 0; k < 2; ++k)
      j.col(k) = (problem.residuals(p + 1e-4 * Vector::Unit(2, k)) - here) / 1e-4;
    return j;
  };
  const SearchEnd end = least_squares(problem);
  EXPECT_TRUE(end == SearchEnd::tolerance || end == SearchEnd::objective_tolerance);
  EXPECT_NEAR(last[1] / last[0], 1.3, 0.02);
  EXPECT_LT(last.norm(), 10);
}

// From far off the first step of the linear model leads to where nothing is defined.
TEST(LeastSquaresTest, AStepThatFailsIsShortened) {
  LeastSquaresProblem problem{.lower = Vector::Constant(1, -infinity),
                              .upper = Vector::Constant(1, infinity),
                              .start = Vector::Constant(1, 50),
                              .residuals = {},
                              .jacobian = {},
                              .tolerance = 1e-10,
                              .most_steps = 100};
  int failed = 0;
  double last = 0;
  problem.residuals = [&](const Vector &p) -> Vector {
    failed += p[0] <= 0 ? 1 : 0;
    if (p[0] <= 0)
      throw NumericalError("no logarithm");
    last = p[0];
    return Vector::Constant(1, std::log(p[0]));
  };
  problem.jacobian = [](const Vector &p) { return Matrix::Constant(1, 1, 1 / p[0]); };
  EXPECT_NE(least_squares(problem), SearchEnd::other);
  EXPECT_GT(failed, 0);
  EXPECT_NEAR(last, 1, 1e-9);
}

// The least value lies where nothing is defined any more: no end is a minimum there.
TEST(LeastSquaresTest, StepsThatFailToTheLastAreNoConvergence) {
  LeastSquaresProblem problem{.lower = Vector::Constant(1, -infinity),
                              .upper = Vector::Constant(1, infinity),
                              .start = Vector::Constant(1, 2),
                              .residuals = {},
                              .jacobian = {},
                              .tolerance = 1e-6,
                              .most_steps = 500};
  problem.residuals = [&](const Vector &p) -> Vector {
    if (p[0] < 1)
      throw NumericalError("too small");
    return p;
  };
  problem.jacobian = [](const Vector &) { return Matrix::Ones(1, 1); };
  EXPECT_EQ(least_squares(problem), SearchEnd::other);
}

TEST(LeastSquaresTest, ExceptionsComeThrough) {
  const Decay decay;
  LeastSquaresProblem problem = decay.problem();
  int calls = 0;
  problem.residuals = [&](const Vector &p) -> Vector {
    if (++calls == 3)
      throw std::runtime_error("enough");
    return decay.at(p) - decay.y;
  };
  EXPECT_THROW(least_squares(problem), std::runtime_error);
  EXPECT_EQ(calls, 3);
}

} // namespace least_squares_tests
} // namespace vibroimpact::analyses
