#include "derived/analysis_arrays.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace vibroimpact::derived {
namespace analysis_arrays_tests {

Field field(const std::string &name, const std::vector<std::string> &dimensions, const Shape &shape,
            const std::vector<double> &values) {
  return {Label(name, "1", "", dimensions), shape, values};
}

PointSequence sequence(const std::vector<PointResult> &points) {
  return [points](const auto &visit) { std::for_each(points.begin(), points.end(), visit); };
}

AnalysisHeader header_with(std::size_t size) {
  return {"a", "transient", {{"case", std::vector<double>(size, 0), {}, "1", ""}}};
}

PointResult point(std::size_t index, const std::vector<Field> &fields) {
  PointResult result;
  result.index = {index};
  result.fields = fields;
  return result;
}

const AssembledField &named(const AnalysisArrays &arrays, const std::string &name) {
  for (const AssembledField &candidate : arrays.fields)
    if (candidate.name() == name)
      return candidate;
  throw std::logic_error("no field " + name);
}

void expect_values(const std::vector<double> &values, const std::vector<double> &expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_TRUE(values[i] == expected[i] || (std::isnan(values[i]) && std::isnan(expected[i])))
        << "value " << i << " is " << values[i];
}

TEST(AnalysisArrays, PadShorterPointsWithNaN) {
  const AnalysisArrays arrays =
      assemble(header_with(3), sequence({point(0, {field("x", {"i", "j"}, {1, 2}, {1, 2})}),
                                         point(2, {field("x", {"i", "j"}, {2, 1}, {3, 4})})}));
  const AssembledField &x = named(arrays, "x");
  EXPECT_EQ(x.shape, (Shape{3, 2, 2}));
  expect_values(x.values, {1, 2, NAN, NAN, NAN, NAN, NAN, NAN, 3, NAN, 4, NAN});
  EXPECT_EQ(arrays.status, (std::vector<std::int64_t>{0, -1, 0}));
}

TEST(AnalysisArrays, SharedTimeIsACoordinate) {
  const Field time = field("time", {"time"}, {2}, {0, 1});
  const AnalysisArrays arrays =
      assemble(header_with(2), sequence({point(0, {time, field("x", {"time"}, {2}, {5, 6})}),
                                         point(1, {time, field("x", {"time"}, {2}, {7, 8})})}));
  EXPECT_EQ(arrays.dimensions.at(0).coordinate, "time");
  expect_values(named(arrays, "time").values, {0, 1});
  expect_values(named(arrays, "x").values, {5, 6, 7, 8});
}

TEST(AnalysisArrays, DifferentTimesStayAField) {
  const AnalysisArrays arrays =
      assemble(header_with(2), sequence({point(0, {field("time", {"time"}, {2}, {0, 1})}),
                                         point(1, {field("time", {"time"}, {2}, {0, 2})})}));
  EXPECT_EQ(arrays.dimensions.at(0).coordinate, "");
  EXPECT_EQ(named(arrays, "time").shape, (Shape{2, 2}));
}

TEST(AnalysisArrays, FailedPointDoesNotDecideOnACoordinate) {
  PointResult failed = point(1, {field("time", {"time"}, {1}, {9})});
  failed.status = Status::failed;
  failed.reason = "diverged";
  const AnalysisArrays arrays = assemble(
      header_with(2), sequence({point(0, {field("time", {"time"}, {2}, {0, 1})}), failed}));
  EXPECT_EQ(arrays.dimensions.at(0).coordinate, "time");
  expect_values(named(arrays, "time").values, {0, 1});
  EXPECT_EQ(arrays.reason, (std::vector<std::string>{"", "diverged"}));
}

TEST(AnalysisArrays, CoordinateOfASubgroupServesOnlyThatGroup) {
  const Field ratio = field("fit/ratio", {"ratio"}, {2}, {0, 1});
  const Field inside = field("fit/x", {"ratio"}, {2}, {5, 6});
  const Field outside = field("y", {"ratio"}, {2}, {5, 6});
  EXPECT_EQ(
      assemble(header_with(1), sequence({point(0, {ratio, inside})})).dimensions.at(0).coordinate,
      "fit/ratio");
  EXPECT_EQ(assemble(header_with(1), sequence({point(0, {ratio, inside, outside})}))
                .dimensions.at(0)
                .coordinate,
            "");
}

TEST(AnalysisArrays, NoImpactsGiveAnEmptyDimension) {
  const AnalysisArrays arrays = assemble(
      {"a", "transient", {}},
      sequence({{{}, Status::finished, "", {field("impact/time", {"impact"}, {0}, {})}, {}, {}}}));
  EXPECT_EQ(named(arrays, "impact/time").shape, (Shape{0}));
}

TEST(AnalysisArrays, OtherDimensionsInAnotherPointAreAnError) {
  EXPECT_THROW(assemble(header_with(2), sequence({point(0, {field("x", {"i"}, {1}, {1})}),
                                                  point(1, {field("x", {"j"}, {1}, {1})})})),
               std::logic_error);
}

TEST(AnalysisArrays, ValuesMustFillTheShape) {
  EXPECT_THROW(check_point(header_with(1), point(0, {field("x", {"i"}, {3}, {1, 2})})),
               std::logic_error);
}

} // namespace analysis_arrays_tests
} // namespace vibroimpact::derived
