#include "output/summary.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace vibroimpact::output {
namespace summary_tests {

derived::PointSequence sequence(const std::vector<PointResult> &points) {
  return [points](const auto &visit) { std::for_each(points.begin(), points.end(), visit); };
}

std::string summary_of(const AnalysisHeader &header, const std::vector<PointResult> &points) {
  PointTotals totals;
  return analysis_summary(header, sequence(points), totals).text();
}

TEST(Summary, LumpedBody) {
  constexpr double two_pi = 6.283185307179586476925;
  reduction::ReducedBody body;
  body.name = "damper";
  body.type = "lumped";
  body.mass = Vector::Constant(1, 0.5);
  body.stiffness = Vector::Constant(1, 0.5 * std::pow(two_pi * 3, 2));
  body.damping = Matrix::Constant(1, 1, 2 * 0.25 * 0.5 * two_pi * 3);
  body.base_participation = Matrix::Zero(1, 3);
  body.base_participation(0, 0) = 0.5;
  body.total_mass = Vector3(0.5, 0, 0);
  EXPECT_EQ(body_summary(body).text(), "body.damper.frequency[1] = 3 [Hz]\n"
                                       "body.damper.damping_ratio[1] = 0.25 [1]\n"
                                       "body.damper.effective_mass[1].x = 0.5 [kg]\n"
                                       "body.damper.effective_mass[1].y = 0 [kg]\n"
                                       "body.damper.effective_mass[1].z = 0 [kg]\n"
                                       "body.damper.total_mass.x = 0.5 [kg]\n"
                                       "body.damper.total_mass.y = 0 [kg]\n"
                                       "body.damper.total_mass.z = 0 [kg]\n");
}

TEST(Summary, PointsAreCountedFromOne) {
  const AnalysisHeader header{"response", "stepped sweep", {}};
  std::vector<PointResult> points;
  for (const std::vector<std::size_t> &index : {std::vector<std::size_t>{0, 9}, {1, 2}, {1, 16}}) {
    PointResult &point = points.emplace_back();
    point.index = index;
    point.summary = {{Label("force", "N", ""), static_cast<double>(index[1])}};
  }
  EXPECT_EQ(summary_of(header, points), "analysis.response[1,10].force = 9 [N]\n"
                                        "analysis.response[2,3].force = 2 [N]\n"
                                        "analysis.response[2,17].force = 16 [N]\n");
}

TEST(Summary, LongMapsAreNotListed) {
  AnalysisHeader header{"map", "stepped sweep", {}};
  header.axes.push_back({.name = "frequency",
                         .values = std::vector<double>(most_listed_points + 9),
                         .labels = {},
                         .unit = "Hz",
                         .description = ""});
  std::vector<PointResult> points;
  for (std::size_t i = 0; i <= most_listed_points; ++i) {
    points.push_back({.index = {i}, .status = Status::finished});
    points.back().summary = {{Label("force", "N", ""), 1}};
  }
  points[3].reason = "It stays at rest.";
  EXPECT_EQ(summary_of(header, points),
            "analysis.map.points = 109 [1]\n# analysis.map[4]: It stays at rest.\n");
  points.pop_back();
  const std::string text = summary_of(header, points);
  EXPECT_EQ(std::ranges::count(text, '\n'), most_listed_points + 1);
  EXPECT_NE(text.find("analysis.map[100].force = 1 [N]"), std::string::npos);
}

TEST(Summary, WithoutAxesThereIsNoIndex) {
  PointResult point;
  point.summary = {{Label("steps", "1", ""), 3}, {Label("/model.mass", "kg", ""), 2}};
  EXPECT_EQ(summary_of({"release", "transient", {}}, {point}),
            "analysis.release.steps = 3 [1]\nmodel.mass = 2 [kg]\n");
}

TEST(Summary, FailedPointsAreCounted) {
  PointResult point;
  point.index = {4};
  point.status = Status::failed;
  EXPECT_EQ(summary_of({"a", "transient", {}}, {point}), "analysis.a.failed_points = 1 [1]\n");
}

std::vector<PointResult> failures(const std::vector<std::string> &reasons) {
  std::vector<PointResult> points;
  for (const std::string &reason : reasons)
    points.push_back({.index = {points.size()},
                      .status = reason.empty() ? Status::finished : Status::failed,
                      .reason = reason});
  return points;
}

// Those that differ in a number only are one.
TEST(Summary, ReasonsOfFailuresAreListedOnceWithTheirCounts) {
  const std::vector<PointResult> points =
      failures({"", "stuck at t = 1.5e-3 s", "more than 7 steps", "stuck at t = 2 s"});
  PointTotals totals;
  EXPECT_EQ(analysis_summary({"a", "transient", {}}, sequence(points), totals).text(),
            "analysis.a.failed_points = 3 [1]\n"
            "analysis.a.failed_points[1] = 2 [1]  stuck at t = 1.5e-3 s\n"
            "analysis.a.failed_points[2] = 1 [1]  more than 7 steps\n");
  EXPECT_EQ(totals.failures(), "3 of 4 points failed:\n"
                               "  2: stuck at t = 1.5e-3 s\n"
                               "  1: more than 7 steps");
  EXPECT_EQ(totals.unsettled(), "");
}

TEST(Summary, ReasonsBeyondTheThirdAreOnlyCounted) {
  const std::vector<PointResult> points = failures({"a", "b", "c", "d", "e", "a"});
  PointTotals totals;
  analysis_summary({"a", "transient", {}}, sequence(points), totals);
  EXPECT_EQ(totals.failures(),
            "6 of 6 points failed:\n  2: a\n  1: b\n  1: c\n  and 2 other reasons");
}

TEST(Summary, PointsThatWereNotSteadyAreCounted) {
  std::vector<PointResult> points(3);
  for (std::size_t i = 0; i < 2; ++i)
    points[i].fields.push_back({.label = Label("steady", "1", ""), .values = {i * 1.0}});
  PointTotals totals;
  EXPECT_EQ(analysis_summary({"a", "steady state", {}}, sequence(points), totals).text(),
            "analysis.a.unsettled_points = 1 [1]\n");
  EXPECT_NE(totals.unsettled().find("1 of 3 points"), std::string::npos);
  EXPECT_EQ(totals.failures(), "");
}

} // namespace summary_tests
} // namespace vibroimpact::output
