// Fits of known curves to data that were made with them.
#include "analyses/design/estimate.h"
#include "analyses/design/known_outcomes.h"
#include "common/error.h"
#include "simulation.h"
#include "temporary_folder.h"

#include <fstream>
#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace estimate_tests {

/// "curve" = a exp(-b x) along x, from 0 to 4 in steps of 0.01, in mm; "number" = a b.
class Curve : public Outcomes {
public:
  void check(const std::string &, const std::vector<parameters::Override> &) const override {}
  Evaluated evaluate(const std::string &, const std::vector<parameters::Override> &overrides,
                     const std::vector<std::string> &names,
                     const std::function<void(double)> &) const override {
    ++calls;
    const double a = std::stod(overrides.at(0).value), b = std::stod(overrides.at(1).value);
    if (b > 3 || calls > good)
      throw NumericalError("too steep");
    if (one_sided && lies_above_another(a, b))
      throw NumericalError("above another");
    Outcome curve{.unit = "m",
                  .one = parameters::evaluate("1 m", {}),
                  .description = "",
                  .axes = {{"x", {}, {}, "s", ""}},
                  .axis_ones = {parameters::evaluate("1 s", {})},
                  .values = {}};
    for (int i = 0; i <= 400; ++i) {
      curve.axes[0].values.push_back(0.01 * i);
      curve.values.push_back(1e-3 * a * std::exp(-b * 0.01 * i));
    }
    const Outcome number{.unit = "1",
                         .one = parameters::evaluate("1", {}),
                         .description = "",
                         .axes = {},
                         .axis_ones = {},
                         .values = {a * b}};
    Evaluated evaluated;
    for (const std::string &name : names)
      evaluated.outcomes.push_back(name == "curve" ? curve : number);
    return evaluated;
  }
  mutable int calls = 0;
  mutable int good = 1 << 30; ///< calls, the others fail
  bool one_sided = false;     ///< fails where differences by larger keys are tried

private:
  /// In one key, by the step of differences.
  bool lies_above_another(double a, double b) const {
    const auto above = [](double one, double other) {
      return std::abs(one - other - 4.9e-4) < 1e-9;
    };
    for (const auto &[other_a, other_b] : seen_)
      if ((above(a, other_a) && b == other_b) || (above(b, other_b) && a == other_a))
        return true;
    seen_.emplace_back(a, b);
    return false;
  }
  mutable std::vector<std::pair<double, double>> seen_;
};

class EstimateTest : public ::testing::Test {
protected:
  /// Data of a = 2, b = 1.3 at x = 0.05, 0.35 ..., in ms and µm.
  void write(double noise = 0) {
    std::ofstream file(folder_.path() / "data.csv");
    file.precision(15);
    file << "time;other;size\n";
    for (int i = 0; i < 12; ++i) {
      const double x = 0.05 + 0.3 * i;
      const double sign = i % 3 == 0 ? 1 : -0.5;
      file << 1e3 * x << ";7;" << 2e3 * std::exp(-1.3 * x) * (1 + sign * noise) << "\n";
    }
  }
  std::shared_ptr<const Analysis> analysis(const std::string &more,
                                           const std::string &bounds = {}) {
    const std::string text =
        "set Variables = a = 1, b = 0.5\nset File folder = " + folder_.path().string() + R"(
subsection Analysis other
end
subsection Analysis fit
  set Type = estimate
  subsection Estimate
    subsection Key a
      set Path = Variables/a
      set Lower = 0.1
      set Upper = 5
      set Start = 1
    end
    subsection Key b
      set Path = Variables/b
)" +
        (bounds.empty() ? "      set Lower = 0.1\n      set Upper = 5\n      set Start = 0.5\n"
                        : bounds) +
        R"(    end
    subsection Data decay
      set Repeat = other
      set Quantity = curve
      set File = data.csv
      set Separator = semicolon
      set Abscissa column = time
      set Abscissa unit = ms
      set Value column = size
      set Value unit = um
    end
)" + more +
        "  end\nend\n";
    const auto set = parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false);
    return create_analysis(set->root().instance("Analysis", "fit"));
  }
  static void run(const Analysis &fit, SearchPoints &points) {
    System system{.model = model::Model({}), .contacts = {}, .integration = {}, .initial = {}};
    for (std::size_t line = 0; line < fit.lines(); ++line)
      fit.run_line(line, system, points);
  }
  testing::TemporaryFolder folder_;
};

TEST_F(EstimateTest, FindsWhatTheDataWereMadeWith) {
  write();
  const Curve curve;
  SearchPoints points(curve);
  run(*analysis(""), points);
  EXPECT_NEAR(points.value({0, 0}, "key/a"), 2, 1e-4); // interpolation between 0.01 s
  EXPECT_NEAR(points.value({0, 0}, "key/b"), 1.3, 1e-4);
  EXPECT_EQ(points.value({0, 0}, "search/bound/a"), 0);
  EXPECT_NEAR(points.values({0, 0}, "measured/decay")[0], 2e-3 * std::exp(-1.3 * 0.05), 1e-9);
  EXPECT_NEAR(points.values({0, 0}, "abscissa/decay")[1], 0.35, 1e-12);
}

// Standard errors are those of the linear model, whose derivatives are known. With so long a step
// differences of first order would be off by a per cent.
TEST_F(EstimateTest, StandardErrorsAreThoseOfTheLinearModel) {
  write(0.02);
  const Curve curve;
  for (const char *step : {"1e-5", "3e-3"}) {
    SearchPoints points(curve);
    run(*analysis(std::string("set Difference = ") + step + "\n"), points);
    const double a = points.value({0, 0}, "key/a"), b = points.value({0, 0}, "key/b");
    const auto x = points.values({0, 0}, "abscissa/decay");
    const auto y = points.values({0, 0}, "measured/decay");
    Matrix j(12, 2);
    Vector r(12);
    for (Index i = 0; i < 12; ++i) {
      const double at = x[static_cast<std::size_t>(i)];
      const double e = 1e-3 * std::exp(-b * at);
      j.row(i) << e, -a * at * e;
      r[i] = a * e - y[static_cast<std::size_t>(i)];
    }
    if (std::stod(step) < 1e-4) { // a minimum
      EXPECT_LT((j.transpose() * r).norm(), 1e-3 * j.norm() * r.norm());
    }
    const Matrix c = r.squaredNorm() / 10 * (j.transpose() * j).inverse();
    const auto expect = [&](const std::string &name, double expected) {
      EXPECT_NEAR(points.value({0, 0}, name) / expected, 1, 1e-3) << name << " " << step;
    };
    expect("standard_error/a", std::sqrt(c(0, 0)));
    expect("standard_error/b", std::sqrt(c(1, 1)));
    EXPECT_NEAR(points.values({0, 0}, "correlation")[1], c(0, 1) / std::sqrt(c(0, 0) * c(1, 1)),
                1e-3);
  }
}

// A deviation in proportion to the values weighs each by itself, and is known.
TEST_F(EstimateTest, ARelativeDeviationCountsEachValueInItsOwn) {
  write(0.02);
  const Curve curve;
  SearchPoints points(curve);
  run(*analysis("", "set Lower = 0.1\nset Upper = 5\nset Start = 0.5\nend\n"
                    "subsection Data other\nset Repeat = other\nset Quantity = curve\n"
                    "set File = data.csv\nset Separator = semicolon\n"
                    "set Abscissa column = time\nset Abscissa unit = ms\n"
                    "set Value column = size\nset Value unit = um\nset Weight = 4\n"
                    "set Relative deviation = 0.05\n"),
      points);
  const auto &residual = points.values({0, 0}, "residual/other");
  const auto &model = points.values({0, 0}, "model/other");
  const auto &measured = points.values({0, 0}, "measured/other");
  for (std::size_t i = 0; i < residual.size(); ++i)
    EXPECT_NEAR(residual[i], 2 * (model[i] / measured[i] - 1) / 0.05, 1e-12);
}

TEST_F(EstimateTest, ABoundThatHoldsIsNamed) {
  write();
  const Curve curve;
  SearchPoints points(curve);
  run(*analysis("", "set Lower = 0.1\nset Upper = 1\nset Start = 0.5\n"), points);
  EXPECT_EQ(points.value({0, 0}, "key/b"), 1);
  EXPECT_EQ(points.value({0, 0}, "search/bound/b"), 1);
  EXPECT_TRUE(std::isnan(points.value({0, 0}, "standard_error/b")));
}

TEST_F(EstimateTest, OneNumberLeavesADirectionFree) {
  write();
  const Curve curve;
  SearchPoints points(curve);
  const auto fit = analysis("subsection Data product\nset Repeat = other\nset Quantity = number\n"
                            "set Value = 2.6\nset Standard deviation = 0.01\nend\n");
  run(*fit, points);
  EXPECT_NEAR(points.value({0, 0}, "key/a") * points.value({0, 0}, "key/b"), 2.6, 1e-3);
  EXPECT_NE(points.all().at({0, 0}).reason.find("leave free: none"), std::string::npos);
}

TEST_F(EstimateTest, FailedEvaluationsArePointsAndOtherStartsGoOn) {
  write();
  const Curve curve;
  SearchPoints points(curve);
  run(*analysis("set Starts = 4\n", "set Lower = 0.1\nset Upper = 5\nset Start = 4\n"), points);
  EXPECT_EQ(points.all().at({0, 1}).reason, "too steep");
  EXPECT_EQ(points.all().at({0, 0}).status, Status::failed);
  int found = 0;
  for (std::size_t start = 1; start < 4; ++start)
    if (points.all().at({start, 0}).status == Status::finished &&
        std::abs(points.value({start, 0}, "key/b") - 1.3) < 1e-3)
      ++found;
  EXPECT_GE(found, 1);
}

TEST_F(EstimateTest, WhereNothingGoesOnTheBestSoFarIsGivenAsNotConverged) {
  write();
  const Curve curve;
  for (int good = 1; good < 12; ++good) {
    curve.calls = 0;
    curve.good = good;
    SearchPoints points(curve);
    run(*analysis("set Most evaluations = 40\n"), points);
    const PointResult &result = points.all().at({0, 0});
    EXPECT_EQ(result.status, Status::failed) << good;
    // The start and its derivatives by two keys are three evaluations.
    EXPECT_TRUE(result.reason.starts_with(good <= 3 ? "no search was made"
                                                    : "the search has not converged"))
        << good << result.reason;
    EXPECT_GE(points.value({0, 0}, "search/failed"), 1) << good;
    EXPECT_GT(points.value({0, 0}, "key/a"), 0) << good;
  }
}

// Wherever the evaluations of the fit end, in the midst of derivatives too, those for the standard
// errors are left; that it has not converged is said.
TEST_F(EstimateTest, EveryNumberOfEvaluationsLeavesStandardErrors) {
  write(0.02);
  const Curve curve;
  int converged = 0;
  for (int most = 1; most < 40; ++most) {
    SearchPoints points(curve);
    run(*analysis("set Most evaluations = " + std::to_string(most) + "\n"), points);
    const PointResult &result = points.all().at({0, 0});
    const bool spent = points.value({0, 0}, "search/end") == 3;
    EXPECT_EQ(result.status, spent ? Status::failed : Status::finished) << most;
    EXPECT_EQ(result.reason.find("ended at Most evaluations = " + std::to_string(most)) !=
                  std::string::npos,
              spent)
        << result.reason;
    converged += spent ? 0 : 1;
    EXPECT_TRUE(std::isfinite(points.value({0, 0}, "standard_error/a"))) << most;
    EXPECT_LE(points.value({0, 0}, "search/evaluations"), most + 4) << most;
  }
  EXPECT_GT(converged, 0);
}

// Differences of one side take twice as many evaluations of the fit, and of those at the end more
// than are left: the best keys so far are the result none the less.
TEST_F(EstimateTest, EvaluationsThatEndAmongThoseForStandardErrorsEndNoRun) {
  write(0.02);
  int without = 0;
  for (int most = 1; most < 16; ++most) {
    Curve curve;
    curve.one_sided = true;
    SearchPoints points(curve);
    run(*analysis("set Most evaluations = " + std::to_string(most) + "\n"), points);
    const PointResult &result = points.all().at({0, 0});
    EXPECT_LE(points.value({0, 0}, "search/evaluations"), most + 4) << most;
    without += std::none_of(result.fields.begin(), result.fields.end(),
                            [](const Field &field) { return field.name() == "standard_error/a"; });
  }
  EXPECT_GT(without, 0);
}

TEST_F(EstimateTest, WhatIsStoredIsNotComputedAgain) {
  write(0.01);
  const Curve curve;
  const auto fit = analysis("set Starts = 2\n");
  SearchPoints whole(curve);
  run(*fit, whole);
  const int calls = curve.calls;
  const CutRun parts(curve, calls, 5, [&](SearchPoints &points) { run(*fit, points); });
  EXPECT_EQ(whole.all().size(), parts.cut.all().size() + parts.resumed.all().size());
  for (const Field &field : whole.all().at({1, 0}).fields) {
    const std::vector<double> &again = parts.resumed.values({1, 0}, field.name());
    for (std::size_t i = 0; i < again.size(); ++i)
      EXPECT_TRUE(again[i] == field.values[i] ||
                  (std::isnan(again[i]) && std::isnan(field.values[i])));
  }
}

} // namespace estimate_tests
} // namespace vibroimpact::analyses
