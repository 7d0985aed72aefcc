// Derivatives of formulas against differences, and at places where they have limits.
#include "parameters/formula.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::parameters {
namespace formula_tests {

Formula of(const std::string &text) { return {text, {}, {"x", "v"}}; }

TEST(FormulaTest, DerivativesOfAllFunctionsAgreeWithDifferences) {
  for (const std::string text : {"x*v",
                                 "x/v",
                                 "x - 3*v + 2",
                                 "-x^1.5*(1 + 0.3*v)",
                                 "x^v",
                                 "v^3 + (-v)^2",
                                 "sqrt(x*v)",
                                 "exp(x - v)",
                                 "ln(x + v^2)",
                                 "log10(x)",
                                 "abs(x - 2*v)",
                                 "min(x, v)",
                                 "max(x, v, 3*x)",
                                 "sin(x)*cos(v)",
                                 "tan(x*v)",
                                 "asin(x - v/3)",
                                 "acos(x*v)",
                                 "atan(x/v)",
                                 "sinh(x)*cosh(v)",
                                 "tanh(x + v)",
                                 "2^x"}) {
    const Formula formula = of(text);
    const double x = 0.31, v = 0.47, h = 1e-4;
    const Dual at = formula(x, v);
    const auto slope = [&](double dx, double dv) {
      const auto along = [&](double step) {
        return (formula(x + step * dx, v + step * dv).value -
                formula(x - step * dx, v - step * dv).value) /
               (2 * step);
      };
      return (4 * along(h / 2) - along(h)) / 3;
    };
    EXPECT_NEAR(at.by[0], slope(1, 0), 1e-10) << text;
    EXPECT_NEAR(at.by[1], slope(0, 1), 1e-10) << text;
  }
}

TEST(FormulaTest, TheValueIsThatOfTheExpression) {
  EXPECT_EQ(of("2*x^3 - v/4")(2, 8).value, 14);
  EXPECT_EQ(of("x^1.5")(0, 1).by[0], 0);
  EXPECT_EQ(of("x*v")(3, 5).by[0], 5);
  EXPECT_EQ(of("abs(v)^1.5")(1, 0).by[1], 0);
}

TEST(FormulaTest, VariablesStandForTheirNumbers) {
  const VariableTable table{{"k", Number{.value = 7}}, {"x", Number{.value = 100}}};
  EXPECT_EQ(Formula("k*x", table, {"x", "v"})(3, 0).value, 21);
  EXPECT_THROW(Formula("k*y", table, {"x", "v"}), Refused);
}

} // namespace formula_tests
} // namespace vibroimpact::parameters
