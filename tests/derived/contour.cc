#include "derived/contour.h"

#include "derived/small_analysis.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::derived {
namespace contour_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

using Surface = std::function<double(double, double)>;

struct Sampled {
  std::vector<double> x, y, values;
  Grid grid() const { return {x, y, values.data()}; }
};

/// A grid over [-1, 1]^2, uneven along the first axis.
Sampled sampled(std::size_t n, const Surface &surface) {
  Sampled result;
  for (std::size_t i = 0; i <= n; ++i) {
    const double s = -1 + 2 * static_cast<double>(i) / static_cast<double>(n);
    result.x.push_back(s * (1 + 0.2 * (1 - s * s)));
    result.y.push_back(s);
  }
  for (const double x : result.x)
    for (const double y : result.y)
      result.values.push_back(surface(x, y));
  return result;
}

double length(const Polyline &line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += std::hypot(line[i].first - line[i - 1].first, line[i].second - line[i - 1].second);
  return sum;
}

TEST(Contour, OfAPlaneIsItsStraightLine) {
  const Sampled plane = sampled(7, [](double x, double y) { return x + 2 * y; });
  const auto lines = level_lines(plane.grid(), 0.3);
  ASSERT_EQ(lines.size(), 1U);
  for (const Vertex &vertex : lines[0])
    EXPECT_NEAR(vertex.first + 2 * vertex.second, 0.3, 1e-14);
  EXPECT_NEAR(length(lines[0]), std::hypot(2, 1), 1e-14); // from border to border
}

TEST(Contour, OfACircleConvergesWithSecondOrder) {
  std::vector<double> errors;
  for (const std::size_t n : {20, 40, 80}) {
    const Sampled bowl = sampled(n, [](double x, double y) { return x * x + y * y; });
    const auto lines = level_lines(bowl.grid(), 0.49);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].front().first, lines[0].back().first);
    EXPECT_EQ(lines[0].front().second, lines[0].back().second);
    errors.push_back(std::abs(length(lines[0]) - 1.4 * std::numbers::pi));
  }
  // Straight lines between points h apart move the line by up to h^2 / 8 r; here h <= 0.12.
  EXPECT_LT(errors[0], 2 * std::numbers::pi * 0.12 * 0.12 / (8 * 0.7));
  EXPECT_NEAR(std::log2(errors[0] / errors[2]) / 2, 2, 0.3);
}

TEST(Contour, TwoHillsAreTwoLines) {
  const Sampled hills = sampled(40, [](double x, double y) {
    return std::exp(-20 * (std::pow(x - 0.5, 2) + y * y)) +
           std::exp(-20 * (std::pow(x + 0.5, 2) + y * y));
  });
  EXPECT_EQ(level_lines(hills.grid(), 0.5).size(), 2U);
  EXPECT_EQ(level_lines(hills.grid(), 2).size(), 0U);
}

TEST(Contour, SaddleFollowsTheMean) {
  const auto lines_of = [](std::vector<double> values) {
    return level_lines({{0, 1}, {0, 1}, values.data()}, 0);
  };
  // High corners on the diagonal: joined when the mean is high, each by itself when it is low.
  for (const auto &[high, corner] : {std::pair{3.0, 1.0}, std::pair{0.25, 0.0}}) {
    const auto lines = lines_of({high, -1, -1, high});
    ASSERT_EQ(lines.size(), 2U);
    bool cuts = false;
    for (const Polyline &line : lines) {
      ASSERT_EQ(line.size(), 2U);
      // The corner (0, corner) lies on the far side of a line from the middle.
      const double middle = 0.5 * (line[0].first + line[1].first);
      const double height = 0.5 * (line[0].second + line[1].second);
      cuts = cuts || (std::abs(middle) < 0.5 && std::abs(height - corner) < 0.5);
    }
    EXPECT_TRUE(cuts) << high;
  }
}

TEST(Contour, StopsAtMissingPoints) {
  Sampled plane = sampled(4, [](double, double y) { return y; });
  plane.values[2 * 5 + 2] = NAN; // in the middle
  const auto lines = level_lines(plane.grid(), 0.1);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].size(), 2U);
}

TEST(Contour, AsAQuantity) {
  SmallAnalysis analysis({0, 1, 2}, {1, 2, 3});
  analysis.add("plane", "1", [](double gap, double, bool) { return gap; });
  const auto result = analysis.derive(
      {{"forward", "set Operation = select\nset Field = plane\nset Where = direction = forward"},
       {"lines", "set Operation = contour\nset Field = forward\nset Levels = 0.25, 1.5"},
       {"none", "set Operation = contour\nset Field = forward\nset Levels = 7"},
       {"bad", "set Operation = contour\nset Field = plane\nset Levels = 1"}});
  ASSERT_EQ(result.arrays.size(), 3U);
  const auto &lines = result.arrays[1];
  EXPECT_EQ(lines.axes, (std::vector<std::string>{"Variables.gap", "frequency"}));
  EXPECT_EQ(lines.dimensions, (std::vector<std::string>{"vertex_lines", "coordinate"}));
  EXPECT_EQ(lines.shape, (Shape{7, 3}));
  const double n = NAN;
  expect_values(lines.values, {0.25, 1,   0.25, 0.25, 2,   0.25, 0.25, 3,   0.25, n,  n,
                               n,    1.5, 1,    1.5,  1.5, 2,    1.5,  1.5, 3,    1.5});
  expect_values(result.arrays[2].values, {n, n, n});
  ASSERT_EQ(result.problems.size(), 1U);
  expect_parts(result.problems[0], {"Derived bad", "Field", "two axes", "3"});
}

// Fields in another unit than that of the SI have their levels in it.
TEST(Contour, LevelsAreInTheUnitOfTheField) {
  SmallAnalysis analysis({0, 1, 2}, {1, 2, 3});
  analysis.add("plane", "Hz", [](double gap, double, bool) { return gap; });
  const auto result = analysis.derive(
      {{"forward", "set Operation = select\nset Field = plane\nset Where = direction = forward"},
       {"line", "set Operation = contour\nset Field = forward\nset Levels = 0.75 Hz"}});
  ASSERT_EQ(result.arrays.size(), 2U);
  expect_values(result.arrays[1].values, {0.75, 1, 0.75, 0.75, 2, 0.75, 0.75, 3, 0.75});
}

} // namespace contour_tests
} // namespace vibroimpact::derived
