// Searches on outcomes that are known functions of the keys.
#include "analyses/design/optimise.h"
#include "common/error.h"
#include "simulation.h"
#include "support/points.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace {

using Arguments = std::map<std::string, double>;
/// Values of the quantities "f" and "g" at values of keys.
using Known = std::function<std::vector<double>(const Arguments &)>;

class KnownOutcomes : public Outcomes {
public:
  explicit KnownOutcomes(Known known) : known_(std::move(known)) {}

  void check(const std::string &, const std::vector<parameters::Override> &) const override {}
  Evaluated evaluate(const std::string &, const std::vector<parameters::Override> &overrides,
                     const std::vector<std::string> &names,
                     const std::function<void(double)> &progress) const override {
    ++calls;
    progress(0.5);
    Arguments arguments;
    for (const parameters::Override &change : overrides)
      arguments[change.path.substr(change.path.find('/') + 1)] = std::stod(change.value);
    const std::vector<double> values = known_(arguments);
    Evaluated evaluated;
    for (std::size_t i = 0; i < names.size(); ++i)
      evaluated.outcomes.push_back({.unit = "m",
                                    .one = parameters::evaluate("1 m", {}),
                                    .description = "",
                                    .axes = {},
                                    .axis_ones = {},
                                    .values = {values.at(i)}});
    return evaluated;
  }
  mutable int calls = 0;

private:
  Known known_;
};

class SearchPoints : public testing::Points {
public:
  explicit SearchPoints(const Outcomes &outcomes) : outcomes_(outcomes) {}
  const Outcomes &outcomes() const override { return outcomes_; }
  void store(PointResult result) override {
    if (left-- == 0)
      throw Interrupted{};
    testing::Points::store(std::move(result));
  }
  void skip() override { ++skipped; }
  int left = -1; ///< points that may be stored
  int skipped = 0;

private:
  const Outcomes &outcomes_;
};

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
  const std::string text = R"(set Variables = x = 1, y = 1, z = 0
subsection Analysis other
end
subsection Analysis search
  set Type = optimise
  subsection Optimise
    set Repeat = other
    set Objective = f
)" + lines + "end\nend\n";
  const auto set = parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false);
  return create_analysis(set->root().instance("Analysis", "search"));
}

System no_system() {
  return {.model = model::Model({}), .contacts = {}, .integration = {}, .initial = {}};
}

/// Runs all lines.
void run(const Analysis &search, SearchPoints &points) {
  System system = no_system();
  for (std::size_t line = 0; line < search.lines(); ++line)
    search.run_line(line, system, points);
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
    run(*search, points);
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
    run(*analysis("subsection Key x\nset Path = Variables/x\nset Lower = " + lower +
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
  run(*analysis("subsection Key x\nset Path = Variables/x\nset Lower = -3\nset Upper = 4\n"
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
  for (const char *method : {"Nelder-Mead", "COBYLA"}) {
    SearchPoints points(outcomes);
    run(*analysis(two_keys + "set Method = " + method +
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
  run(*analysis(two_keys + "set Most evaluations = 20\n"), none);
  EXPECT_EQ(none.all().at({0, 0}).status, Status::failed);
  EXPECT_NE(none.all().at({0, 0}).reason.find("evaluations failed, the first one: no motion"),
            std::string::npos)
      << none.all().at({0, 0}).reason;
  const KnownOutcomes outcomes(valley);
  SearchPoints infeasible(outcomes);
  run(*analysis(two_keys + "set Most evaluations = 60\nset Method = COBYLA\n"
                           "subsection Constraint area\nset Quantity = g\nset Lower = 20 m\nend\n"),
      infeasible);
  EXPECT_NE(infeasible.all().at({0, 0}).reason.find("no evaluation meets the constraints"),
            std::string::npos)
      << infeasible.all().at({0, 0}).reason;
}

TEST(OptimiseTest, WhatIsStoredIsNotComputedAgain) {
  const KnownOutcomes outcomes(valley);
  for (const char *method : {"Nelder-Mead", "BOBYQA", "COBYLA", "ISRES"}) {
    const auto search = analysis(two_keys + "set Most evaluations = 60\nset Method = " + method +
                                 "\nset Starts = 2\n");
    SearchPoints whole(outcomes);
    outcomes.calls = 0;
    run(*search, whole);
    const int calls = outcomes.calls;
    outcomes.calls = 0;
    SearchPoints cut(outcomes);
    cut.left = 17;
    EXPECT_THROW(run(*search, cut), Interrupted);
    SearchPoints resumed(outcomes);
    for (const auto &[index, point] : cut.all())
      resumed.know(point);
    run(*search, resumed);
    EXPECT_EQ(outcomes.calls, calls + 1) << method; // the one that was cut off
    for (const auto &[index, point] : whole.all()) {
      const auto &from = cut.all().count(index) > 0 ? cut : resumed;
      ASSERT_EQ(from.all().count(index), 1U) << method;
      for (const Field &field : point.fields)
        EXPECT_EQ(from.values(index, field.name()), field.values) << method << " " << field.name();
    }
    EXPECT_EQ(whole.all().size(), cut.all().size() + resumed.all().size()) << method;
  }
}

TEST(OptimiseTest, AFinishedStartIsPassedOver) {
  const KnownOutcomes outcomes(valley);
  const auto search = analysis(two_keys + "set Most evaluations = 30\n");
  SearchPoints whole(outcomes);
  run(*search, whole);
  SearchPoints again(outcomes);
  for (const auto &[index, point] : whole.all())
    again.know(point);
  outcomes.calls = 0;
  run(*search, again);
  EXPECT_EQ(outcomes.calls, 0);
  EXPECT_EQ(again.skipped, 31);
}

} // namespace
} // namespace vibroimpact::analyses
