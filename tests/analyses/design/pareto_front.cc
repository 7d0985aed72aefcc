// Pareto fronts that are known in closed form.
#include "analyses/design/pareto_front.h"
#include "analyses/design/known_outcomes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::analyses {
namespace pareto_front_tests {

std::shared_ptr<const Analysis> pareto(const std::string &lines) {
  return search_analysis(R"(set Type = pareto front
subsection Pareto front
set Repeat = other
subsection Objective first
  set Quantity = f
end
subsection Objective second
  set Quantity = g
end
)" + lines + "end\n");
}

std::string key(const std::string &name, const std::string &lower, const std::string &upper) {
  return "subsection Key " + name + "\nset Path = Variables/" + name + "\nset Lower = " + lower +
         "\nset Upper = " + upper + "\nend\n";
}

struct Front {
  std::vector<double> first, second;
  double widest() const { ///< distance of neighbours, relative to that of the ends
    double widest = 0;
    for (std::size_t i = 1; i < first.size(); ++i)
      widest =
          std::max(widest, std::hypot((first[i] - first[i - 1]) / (first.back() - first[0]),
                                      (second[i] - second[i - 1]) / (second[0] - second.back())));
    return widest;
  }
};

Front front_of(const SearchPoints &points) {
  return {points.values({0}, "front/objective/first"),
          points.values({0}, "front/objective/second")};
}

// x^2 and (x - 2)^2 (Schaffer): sqrt g = 2 - sqrt f, 0 <= f <= 4.
TEST(ParetoFrontTest, OfTwoParabolas) {
  const KnownOutcomes outcomes([](const Arguments &at) {
    return std::vector<double>{std::pow(at.at("x"), 2), std::pow(at.at("x") - 2, 2)};
  });
  SearchPoints points(outcomes);
  run_all(*pareto(key("x", "-10", "10") + "set Evaluations = 600\n"), points);
  const Front front = front_of(points);
  ASSERT_GT(front.first.size(), 40U);
  for (std::size_t i = 0; i < front.first.size(); ++i)
    EXPECT_NEAR(std::sqrt(front.second[i]), std::abs(2 - std::sqrt(front.first[i])), 1e-12);
  EXPECT_NEAR(front.first.front(), 0, 1e-3);
  EXPECT_NEAR(front.first.back(), 4, 0.1);
  EXPECT_LT(front.widest(), 0.1);
  EXPECT_EQ(points.value({0}, "search/evaluations"), outcomes.calls);
}

// f = x, g = (1 + 9 (y + z)/2) (1 - sqrt(f / (1 + 9 (y + z)/2))) (ZDT1 with three keys):
// g = 1 - sqrt f, at y = z = 0.
TEST(ParetoFrontTest, AtTheBoundsOfSomeKeys) {
  const KnownOutcomes outcomes([](const Arguments &at) {
    const double h = 1 + 4.5 * (at.at("y") + at.at("z"));
    return std::vector<double>{at.at("x"), h * (1 - std::sqrt(at.at("x") / h))};
  });
  SearchPoints points(outcomes);
  run_all(*pareto(key("x", "0", "1") + key("y", "0", "1") + key("z", "0", "1") +
                  "set Evaluations = 1500\n"),
          points);
  const Front front = front_of(points);
  ASSERT_GT(front.first.size(), 40U);
  double sum = 0;
  for (std::size_t i = 0; i < front.first.size(); ++i) {
    const double beyond = front.second[i] - (1 - std::sqrt(front.first[i]));
    EXPECT_GE(beyond, -1e-15); // nothing is better than the front
    EXPECT_LT(beyond, 0.02);
    sum += beyond;
  }
  EXPECT_LT(sum / static_cast<double>(front.first.size()), 1e-3);
  EXPECT_LT(front.widest(), 0.15);
}

// Largest x and largest y with x^2 + y^2 <= 1, which is (f, g, h) = (x, y, x^2 + y^2): the arc.
TEST(ParetoFrontTest, OnAConstraintAndOfTheLargest) {
  const KnownOutcomes outcomes([](const Arguments &at) {
    const double x = at.at("x"), y = at.at("y");
    return std::vector<double>{x, y, x * x + y * y};
  });
  SearchPoints points(outcomes);
  const auto analysis = search_analysis(R"(set Type = pareto front
subsection Pareto front
set Repeat = other
set Evaluations = 3000
subsection Objective first
  set Quantity = f
  set Sense = maximise
end
subsection Objective second
  set Quantity = g
  set Sense = maximise
end
subsection Constraint circle
  set Quantity = h
  set Upper = 1 m
end
)" + key("x", "0", "2") + key("y", "0", "2") +
                                        "end\n");
  run_all(*analysis, points);
  const Front front = front_of(points);
  ASSERT_GT(front.first.size(), 20U);
  double sum = 0;
  for (std::size_t i = 0; i < front.first.size(); ++i) {
    const double inside = 1 - std::hypot(front.first[i], front.second[i]);
    EXPECT_GE(inside, -1e-6);
    EXPECT_LT(inside, 0.03);
    sum += inside;
  }
  EXPECT_LT(sum / static_cast<double>(front.first.size()), 0.01);
  EXPECT_GT(front.first.front(), front.first.back()); // the best of the first objective first
}

TEST(ParetoFrontTest, WhatIsStoredIsNotComputedAgain) {
  const KnownOutcomes outcomes([](const Arguments &at) {
    return std::vector<double>{std::pow(at.at("x"), 2), std::pow(at.at("x") - 2, 2)};
  });
  const auto analysis = pareto(key("x", "-10", "10") + "set Evaluations = 150\n");
  SearchPoints whole(outcomes);
  run_all(*analysis, whole);
  const auto again = pareto(key("x", "-10", "10") + "set Evaluations = 150\n");
  SearchPoints resumed(outcomes);
  std::size_t known = 0;
  for (const auto &[index, point] : whole.all())
    if (index[0] > 0 && known++ < 70)
      resumed.know(point);
  outcomes.calls = 0;
  run_all(*again, resumed);
  EXPECT_EQ(outcomes.calls, 80);
  EXPECT_EQ(front_of(resumed).first, front_of(whole).first);
}

TEST(ParetoFrontTest, NothingGoodSaysWhy) {
  const KnownOutcomes failing(
      [](const Arguments &) -> std::vector<double> { throw NumericalError("no motion"); });
  SearchPoints points(failing);
  run_all(*pareto(key("x", "0", "1") + "set Evaluations = 20\n"), points);
  EXPECT_EQ(points.all().at({0}).status, Status::failed);
  EXPECT_EQ(points.all().at({0}).reason, "all 20 evaluations failed, the first one: no motion");
}

} // namespace pareto_front_tests
} // namespace vibroimpact::analyses
