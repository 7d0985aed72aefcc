// The methods of searches on functions whose least value is known.
#include "analyses/design/nlopt_search.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace nlopt_search_tests {

constexpr double infinity = std::numeric_limits<double>::infinity();

SearchProblem problem(Index n, std::function<double(const Vector &)> objective) {
  return {.lower = Vector::Constant(n, -2),
          .upper = Vector::Constant(n, 3),
          .start = Vector::Constant(n, -0.9),
          .step = Vector::Constant(n, 0.1),
          .objective = std::move(objective),
          .constraints = {},
          .constraint_tolerance = 1e-9,
          .tolerance = 1e-7,
          .most_calls = 20000,
          .seed = 1};
}

// Least at (1, 1).
double valley(const Vector &x) {
  return std::pow(1 - x[0], 2) + 10 * std::pow(x[1] - x[0] * x[0], 2);
}

class NloptSearchOf : public ::testing::TestWithParam<const char *> {};

TEST_P(NloptSearchOf, FindsTheEndOfAValley) {
  Vector last;
  double least = infinity;
  search(*search_method(GetParam()), problem(2, [&](const Vector &x) {
    if (valley(x) < least) {
      least = valley(x);
      last = x;
    }
    return valley(x);
  }));
  EXPECT_NEAR(last[0], 1, 2e-3);
  EXPECT_NEAR(last[1], 1, 4e-3);
}

INSTANTIATE_TEST_SUITE_P(NloptSearchMethods, NloptSearchOf,
                         ::testing::Values("Nelder-Mead", "subplex", "BOBYQA", "COBYLA", "DIRECT",
                                           "ISRES"));

TEST(NloptSearchTest, OneKeyIsEnoughForAnyMethod) {
  for (const SearchMethod &method : search_methods()) {
    double at = 0, least = infinity;
    search(method, problem(1, [&](const Vector &x) {
             const double value = std::pow(x[0] - 0.3, 2);
             if (value < least) {
               least = value;
               at = x[0];
             }
             return value;
           }));
    EXPECT_NEAR(at, 0.3, 1e-3) << method.name;
  }
}

// x + y with x y >= 1 and x, y > 0 is least at (1, 1).
TEST(NloptSearchTest, ConstraintsHold) {
  for (const char *name : {"COBYLA", "ISRES"}) {
    SearchProblem constrained = problem(2, [](const Vector &x) { return x[0] + x[1]; });
    constrained.lower.setConstant(0.01);
    constrained.start.setConstant(2.5);
    constrained.constraints.emplace_back([](const Vector &x) { return 1 - x[0] * x[1]; });
    Vector best;
    constrained.objective = [&](const Vector &x) {
      if (x[0] * x[1] >= 1 - 1e-9 && (best.size() == 0 || x.sum() < best.sum()))
        best = x;
      return x.sum();
    };
    search(*search_method(name), constrained);
    ASSERT_EQ(best.size(), 2) << name;
    EXPECT_NEAR(best.sum(), 2, 2e-3) << name;
  }
}

TEST(NloptSearchTest, ExceptionsComeThrough) {
  int calls = 0;
  const auto failing = [&](const Vector &) -> double {
    if (++calls == 5)
      throw std::runtime_error("enough");
    return calls;
  };
  for (const SearchMethod &method : search_methods()) {
    calls = 0;
    EXPECT_THROW(search(method, problem(2, failing)), std::runtime_error) << method.name;
    EXPECT_EQ(calls, 5) << method.name;
  }
}

TEST(NloptSearchTest, EndsAreKnown) {
  SearchProblem small = problem(2, [](const Vector &x) { return 1 + valley(x); });
  EXPECT_EQ(search(*search_method("Nelder-Mead"), small), SearchEnd::tolerance);
  small.most_calls = 7;
  EXPECT_EQ(search(*search_method("Nelder-Mead"), small), SearchEnd::evaluations);
  small.most_calls = 20000;
  small.objective_tolerance = 0.1;
  EXPECT_EQ(search(*search_method("Nelder-Mead"), small), SearchEnd::objective_tolerance);
}

TEST(NloptSearchTest, ASeedDecidesWhatIsDrawn) {
  const auto visited = [](unsigned long seed) {
    std::vector<double> all;
    SearchProblem drawn = problem(2, [&](const Vector &x) {
      all.insert(all.end(), x.begin(), x.end());
      return valley(x);
    });
    drawn.seed = seed;
    drawn.most_calls = 100;
    search(*search_method("ISRES"), drawn);
    return all;
  };
  EXPECT_EQ(visited(3), visited(3));
  EXPECT_NE(visited(3), visited(4));
}

} // namespace nlopt_search_tests
} // namespace vibroimpact::analyses
