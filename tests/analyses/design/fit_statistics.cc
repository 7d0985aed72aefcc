// Standard errors and combinations against closed forms of linear models.
#include "analyses/design/fit_statistics.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace fit_statistics_tests {

// y = p0 + p1 x at x = -1, 0, 1, 2: var p = s^2 (X'X)^-1.
TEST(FitStatisticsTest, OfAStraightLine) {
  Matrix x(4, 2);
  x << 1, -1, 1, 0, 1, 1, 1, 2;
  const Eigen::Vector4d r(0.1, -0.2, 0.1, 0.3);
  const Eigen::Vector2d sizes(7, 0.01); // whatever they are
  const FitStatistics fit = fit_statistics(r, x, sizes, {false, false}, false);
  const double s2 = r.squaredNorm() / 2;
  const Matrix c = s2 * (x.transpose() * x).inverse();
  EXPECT_NEAR(fit.residual_variance, s2, 1e-14);
  EXPECT_NEAR(fit.standard_error[0], std::sqrt(c(0, 0)), 1e-12);
  EXPECT_NEAR(fit.standard_error[1], std::sqrt(c(1, 1)), 1e-12);
  EXPECT_NEAR(fit.correlation(0, 1), c(0, 1) / std::sqrt(c(0, 0) * c(1, 1)), 1e-10);
  EXPECT_NEAR(fit.half_width[0] / fit.standard_error[0], 4.302652729911, 1e-9); // t(2), 97.5 %
  const FitStatistics known = fit_statistics(r, x, sizes, {false, false}, true);
  EXPECT_NEAR(known.standard_error[0], std::sqrt(c(0, 0) / s2), 1e-12);
  EXPECT_NEAR(known.half_width[0] / known.standard_error[0], 1.959963984540, 1e-9);
}

TEST(FitStatisticsTest, AKeyAtABoundHasNoError) {
  Matrix x(4, 2);
  x << 1, -1, 1, 0, 1, 1, 1, 2;
  const Eigen::Vector4d r(0.1, -0.2, 0.1, 0.3);
  const FitStatistics fit = fit_statistics(r, x, Eigen::Vector2d(1, 1), {false, true}, false);
  EXPECT_NEAR(fit.standard_error[0], std::sqrt(r.squaredNorm() / 3 / 4), 1e-14);
  EXPECT_TRUE(std::isnan(fit.standard_error[1]));
  EXPECT_TRUE(std::isnan(fit.correlation(0, 1)));
}

// Residuals depend on p0 / p1 and on p2: the first two may grow together.
TEST(FitStatisticsTest, FreeDirectionsAreFoundAndNamed) {
  const Eigen::Vector3d p(2, 50, -3);
  Matrix j(6, 3);
  const Vector a = Eigen::Matrix<double, 6, 1>{1, 2, -1, 0.5, 3, 1};
  const Vector b = Eigen::Matrix<double, 6, 1>{0.3, -1, 2, 1, 0, 1};
  j << a / p[0], -a / p[1], b;
  const Vector r = 0.01 * Vector::Ones(6);
  const FitStatistics fit = fit_statistics(r, j, p.cwiseAbs(), {false, false, false}, false);
  EXPECT_LT(fit.singular_value[2], 1e-12 * fit.singular_value[0]);
  EXPECT_TRUE(std::isinf(fit.standard_error[0]));
  EXPECT_TRUE(std::isinf(fit.standard_error[1]));
  EXPECT_NEAR(fit.standard_error[2],
              std::sqrt(r.squaredNorm() / 3 * a.squaredNorm() /
                        (a.squaredNorm() * b.squaredNorm() - std::pow(a.dot(b), 2))),
              1e-10);
  EXPECT_NEAR(std::abs(fit.direction(2, 0) + fit.direction(2, 1)), std::sqrt(2), 1e-9);
  const std::string words = combinations_in_words(fit, {"mass", "stiffness", "gap"});
  EXPECT_NE(words.find("leave free: mass, stiffness as 1 : 1"), std::string::npos) << words;
}

} // namespace fit_statistics_tests
} // namespace vibroimpact::analyses
