// Polynomials of degree two are recognised, whatever the sizes of their terms; others are not.
#include "motion/phase/quadratic_form.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace quadratic_form_tests {

TEST(QuadraticFormTest, TermsOfVeryDifferentSize) {
  const auto f = [](const Vector &x) {
    return 1e10 * x[0] * x[0] + 2e3 * x[0] * x[1] + 1e-2 * x[1] * x[1] + 4 * x[1] + 3;
  };
  const std::optional<Matrix> form = quadratic_form(f, 2);
  ASSERT_TRUE(form.has_value());
  EXPECT_NEAR((*form)(0, 0), 1e10, 1e-2);
  EXPECT_NEAR((*form)(0, 1), 1e3, 1e-9);
  EXPECT_NEAR((*form)(1, 1), 1e-2, 1e-14);
  EXPECT_NEAR((*form)(1, 2), 2, 1e-12);
  EXPECT_NEAR((*form)(2, 2), 3, 1e-15);
  EXPECT_NEAR((*form)(0, 2), 0, 1e-7);
}

// Where the square is one, the linear term is 1e9 with a rounding of 1e-7: the square is known to
// as much. Near zero it would be lost.
TEST(QuadraticFormTest, ASquareBesideALargeLinearTerm) {
  const std::optional<Matrix> form =
      quadratic_form([](const Vector &x) { return 1e-6 * x[0] * x[0] + 1e6 * x[0]; }, 1);
  ASSERT_TRUE(form.has_value());
  EXPECT_NEAR((*form)(0, 0), 1e-6, 1e-12);
  EXPECT_NEAR((*form)(0, 1), 5e5, 1e-6);
}

TEST(QuadraticFormTest, NothingIsAForm) {
  const std::optional<Matrix> form = quadratic_form([](const Vector &) { return 0.0; }, 3);
  ASSERT_TRUE(form.has_value());
  EXPECT_TRUE(form->isZero(0));
}

// The digits of so small a number do not suffice for any comparison.
TEST(QuadraticFormTest, ATermBelowTheSmallestNormalNumber) {
  const std::optional<Matrix> form =
      quadratic_form([](const Vector &x) { return 1e-320 * x[0] * x[0] + 5 * x[1] * x[1]; }, 2);
  ASSERT_TRUE(form.has_value());
  EXPECT_NEAR((*form)(0, 0), 0, 1e-307);
  EXPECT_NEAR((*form)(1, 1), 5, 1e-14);
}

TEST(QuadraticFormTest, OtherFunctionsAreRefused) {
  EXPECT_FALSE(quadratic_form([](const Vector &x) { return std::abs(x[0]); }, 1).has_value());
  EXPECT_FALSE(quadratic_form([](const Vector &x) { return std::max(0.0, x[0] * x[0] * x[1]); }, 2)
                   .has_value());
  EXPECT_FALSE(
      quadratic_form([](const Vector &x) { return std::pow(std::abs(x[0]), 1.5); }, 1).has_value());
}

} // namespace quadratic_form_tests
} // namespace vibroimpact::motion
