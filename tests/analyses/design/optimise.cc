// Searches on outcomes that are known functions of the keys.
#include "analyses/design/optimise.h"
#include "analyses/design/known_outcomes.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace optimise_tests {

const std::string two_keys = R"(subsection Key x
  set Path = Variables/x
  set Lower = -2
  set Upper = 3
  set Start = -1
end
subsection Key y
  set Path = Variables/y
  set Lower = -2
  set Upper = 3
  set Start = -1
end
)";

std::shared_ptr<const Analysis> analysis(const std::string &lines) {
  return search_analysis("set Type = optimise\nsubsection Optimise\nset Repeat = other\n"
                         "set Objective = f\n" +
                         lines + "end\n");
}

// Least at (1, 1).
std::vector<double> valley(const Arguments &at) {
  const double x = at.at("x"), y = at.at("y");
  return {std::pow(1 - x, 2) + 10 * std::pow(y - x * x, 2), x * y};
}

TEST(OptimiseTest, FindsTheLeastAndTheLargest) {
  for (const bool maximise : {false, true}) {
    const KnownOutcomes outcomes([&](const Arguments &at) {
      return std::vector<double>{(maximise ? -1 : 1) * valley(at)[0] + 4};
    });
    SearchPoints points(outcomes);
    const auto search = analysis(two_keys + "set Tolerance = 1e-7\nset Most evaluations = 500\n" +
                                 (maximise ? "set Sense = maximise\n" : ""));
    run_all(*search, points);
    EXPECT_NEAR(points.value({0, 0}, "key/x"), 1, 1e-4);
    EXPECT_NEAR(points.value({0, 0}, "key/y"), 1, 1e-4);
    EXPECT_NEAR(points.value({0, 0}, "objective"), 4, 1e-8);
    EXPECT_EQ(points.value({0, 0}, "search/end"), 1);
    const double best = points.value({0, 0}, "search/best");
    EXPECT_EQ(points.value({0, static_cast<std::size_t>(best)}, "objective"),
              points.value({0, 0}, "objective"));
    EXPECT_EQ(static_cast<double>(outcomes.calls), points.value({0, 0}, "search/evaluations"));
    EXPECT_EQ(outcomes.calls + points.skipped, 500);
  }
}

TEST(OptimiseTest, BoundsAndConstraintsThatAreActiveAreNamed) {
  // f = x + y; with g = x y >= 1 it is least at (1, 1), with x >= 2 at (2, 0.5).
  const KnownOutcomes outcomes([](const Arguments &at) {
    return std::vector<double>{at.at("x") + at.at("y"), at.at("x") * at.at("y")};
  });
  const auto run_with = [&](const std::string &lower) {
    SearchPoints points(outcomes);
    run_all(*analysis("subsection Key x\nset Path = Variables/x\nset Lower = " + lower +
                      "\nset Upper = 4\nend\nsubsection Key y\nset Path = Variables/y\n"
                      "set Lower = 0.1\nset Upper = 4\nend\nsubsection Constraint area\n"
                      "set Quantity = g\nset Lower = 100 cm\nend\n"
                      "set Method = COBYLA\nset Tolerance = 1e-6\n"),
            points);
    return points;
  };
  const SearchPoints free = run_with("0.1");
  EXPECT_NEAR(free.value({0, 0}, "objective"), 2, 1e-4);
  EXPECT_EQ(free.value({0, 0}, "search/bound/x"), 0);
  EXPECT_EQ(free.value({0, 0}, "search/active/area"), 1);
  EXPECT_NEAR(free.value({0, 0}, "constraint/area"), 1, 1e-5);
  const SearchPoints bound = run_with("2");
  EXPECT_NEAR(bound.value({0, 0}, "objective"), 2.5, 1e-4);
  EXPECT_EQ(bound.value({0, 0}, "search/bound/x"), -1);
}

TEST(OptimiseTest, TheWorstCaseCounts) {
  // The largest of |x - z| over z = 0 and z = 1 is least in the middle.
  const KnownOutcomes outcomes(
      [](const Arguments &at) { return std::vector<double>{std::abs(at.at("x") - at.at("z"))}; });
  SearchPoints points(outcomes);
  run_all(*analysis("subsection Key x\nset Path = Variables/x\nset Lower = -3\nset Upper = 4\n"
                    "set Start = 3\nend\nsubsection Worst over z\nset Path = Variables/z\n"
                    "set Values = 0, 1, 0.5\nend\nset Tolerance = 1e-6\n"),
          points);
  EXPECT_NEAR(points.value({0, 0}, "key/x"), 0.5, 1e-4);
  EXPECT_NEAR(points.value({0, 0}, "objective"), 0.5, 1e-4);
  EXPECT_EQ(points.values({0, 1}, "case_objective"), (std::vector<double>{3, 2, 2.5}));
}

TEST(OptimiseTest, FailedEvaluationsArePointsWithTheirReason) {
  const KnownOutcomes outcomes([](const Arguments &at) {
    if (at.at("x") < 0.9)
      throw NumericalError("too small an x");
    return std::vector<double>{std::pow(at.at("x") - 1, 2) + std::pow(at.at("y") - 1, 2)};
  });
  for (const char *method : {"Nelder-Mead", "COBYLA", "differential evolution"}) {
    SearchPoints points(outcomes);
    run_all(*analysis(two_keys + "set Method = " + method +
                      "\nset Most evaluations = 400\nset Starts = 3\nset Tolerance = 1e-6\n"),
            points);
    const PointResult &first = points.all().at({0, 1}); // x = -1
    EXPECT_EQ(first.status, Status::failed);
    EXPECT_EQ(first.reason, "too small an x");
    EXPECT_EQ(points.value({0, 1}, "key/x"), -1);
    double least = 1e300;
    for (std::size_t start = 0; start < 3; ++start)
      if (points.all().at({start, 0}).status == Status::finished)
        least = std::min(least, points.value({start, 0}, "objective"));
    EXPECT_LT(least, 1e-4) << method;
  }
}

TEST(OptimiseTest, ASearchWithoutAnyGoodEvaluationSaysWhy) {
  const KnownOutcomes failing(
      [](const Arguments &) -> std::vector<double> { throw NumericalError("no motion"); });
  SearchPoints none(failing);
  run_all(*analysis(two_keys + "set Most evaluations = 20\n"), none);
  EXPECT_EQ(none.all().at({0, 0}).status, Status::failed);
  EXPECT_NE(none.all().at({0, 0}).reason.find("evaluations failed, the first one: no motion"),
            std::string::npos)
      << none.all().at({0, 0}).reason;
  const KnownOutcomes outcomes(valley);
  SearchPoints infeasible(outcomes);
  run_all(*analysis(two_keys +
                    "set Most evaluations = 60\nset Method = COBYLA\n"
                    "subsection Constraint area\nset Quantity = g\nset Lower = 20 m\nend\n"),
          infeasible);
  EXPECT_NE(infeasible.all().at({0, 0}).reason.find("no evaluation meets the constraints"),
            std::string::npos)
      << infeasible.all().at({0, 0}).reason;
}

TEST(OptimiseTest, WhatIsStoredIsNotComputedAgain) {
  const KnownOutcomes outcomes(valley);
  for (const char *method :
       {"Nelder-Mead", "BOBYQA", "COBYLA", "ISRES", "differential evolution"}) {
    const auto search = analysis(two_keys + "set Most evaluations = 60\nset Method = " + method +
                                 "\nset Starts = 2\n");
    SearchPoints whole(outcomes);
    outcomes.calls = 0;
    run_all(*search, whole);
    const int calls = outcomes.calls;
    const CutRun parts(outcomes, calls, 17,
                       [&](SearchPoints &points) { run_all(*search, points); });
    for (const auto &[index, point] : whole.all()) {
      const auto &from = parts.cut.all().count(index) > 0 ? parts.cut : parts.resumed;
      ASSERT_EQ(from.all().count(index), 1U) << method;
      for (const Field &field : point.fields)
        EXPECT_EQ(from.values(index, field.name()), field.values) << method << " " << field.name();
    }
    EXPECT_EQ(whole.all().size(), parts.cut.all().size() + parts.resumed.all().size()) << method;
  }
}

// Rastrigin's function has 121 minima in the box; the least, 0, at (0, 0).
TEST(OptimiseTest, APopulationFindsTheLeastOfManyMinima) {
  const KnownOutcomes outcomes([](const Arguments &at) {
    double sum = 20;
    for (const char *key : {"x", "y"})
      sum += at.at(key) * at.at(key) - 10 * std::cos(2 * std::numbers::pi * at.at(key));
    return std::vector<double>{sum};
  });
  SearchPoints points(outcomes);
  run_all(*analysis(R"(set Method = differential evolution
set Most evaluations = 3000
set Starts = 3
set Tolerance = 1e-6
subsection Key x
  set Path = Variables/x
  set Lower = -5
  set Upper = 6
end
subsection Key y
  set Path = Variables/y
  set Lower = -5
  set Upper = 6
end
)"),
          points);
  double least = 1e300;
  for (std::size_t start = 0; start < 3; ++start) {
    least = std::min(least, points.value({start, 0}, "objective"));
  }
  EXPECT_LT(least, 1e-8);
}

TEST(OptimiseTest, APopulationMeetsConstraintsThatAreActive) {
  // f = x + y; with g = x y >= 1 it is least at (1, 1).
  const KnownOutcomes outcomes([](const Arguments &at) {
    return std::vector<double>{at.at("x") + at.at("y"), at.at("x") * at.at("y")};
  });
  SearchPoints points(outcomes);
  run_all(
      *analysis("subsection Key x\nset Path = Variables/x\nset Lower = 0.1\nset Upper = 4\nend\n"
                "subsection Key y\nset Path = Variables/y\nset Lower = 0.1\nset Upper = 4\nend\n"
                "subsection Constraint area\nset Quantity = g\nset Lower = 1 m\nend\n"
                "set Method = differential evolution\nset Tolerance = 1e-3\n"
                "set Most evaluations = 2000\n"),
      points);
  EXPECT_NEAR(points.value({0, 0}, "objective"), 2, 1e-3);
  EXPECT_EQ(points.value({0, 0}, "search/end"), 1); // before all are spent
  EXPECT_EQ(outcomes.calls + points.skipped, 2000);
  EXPECT_EQ(points.value({0, 0}, "search/active/area"), 1);
  EXPECT_GE(points.value({0, 0}, "constraint/area"), 1 - 1e-6);
}

TEST(OptimiseTest, AFinishedStartIsPassedOver) {
  const KnownOutcomes outcomes(valley);
  const auto search = analysis(two_keys + "set Most evaluations = 30\n");
  SearchPoints whole(outcomes);
  run_all(*search, whole);
  SearchPoints again(outcomes);
  for (const auto &[index, point] : whole.all())
    again.know(point);
  outcomes.calls = 0;
  run_all(*search, again);
  EXPECT_EQ(outcomes.calls, 0);
  EXPECT_EQ(again.skipped, 31);
}

} // namespace optimise_tests
} // namespace vibroimpact::analyses
