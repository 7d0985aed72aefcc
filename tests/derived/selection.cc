#include "derived/small_analysis.h"

namespace vibroimpact::derived {
namespace selection_tests {

using testing::expect_parts;
using testing::expect_values;
using testing::SmallAnalysis;

SmallAnalysis numbered() {
  SmallAnalysis analysis({0, 0.1}, {1, 2, 3});
  analysis.add("code", "1", [](double gap, double frequency, bool forward) {
    return 1000 * gap + 10 * frequency + (forward ? 1 : 2);
  });
  return analysis;
}

TEST(Selection, ByLabelAndByValue) {
  const SmallAnalysis analysis = numbered();
  const auto forward = analysis.derive_one(
      "set Operation = select\nset Field = code\nset Where = direction=forward");
  EXPECT_EQ(forward.dimensions, (std::vector<std::string>{"Variables.gap", "frequency"}));
  expect_values(forward.values, {11, 21, 31, 111, 121, 131});
  expect_values(
      analysis
          .derive_one("set Operation = select\nset Field = code\nset Where = clearance = 1 / 10")
          .values,
      {111, 112, 121, 122, 131, 132});
}

TEST(Selection, SeveralPlacesAtOnceAndUnits) {
  const auto value = numbered().derive_one(
      "set Operation = select\nset Field = code\n"
      "set Where = frequency = 4 * pi * 1 rad/s, direction = backward, gap = 0");
  EXPECT_TRUE(value.shape.empty());
  expect_values(value.values, {22});
}

TEST(Selection, CoordinatesStayCoordinates) {
  const std::string field = "\nset Field = where\nset ";
  const auto result = numbered().derive(
      {{"where", "set Operation = position of maximum\nset Field = code\nset Along = frequency"},
       {"part", "set Operation = select" + field + "Where = gap = 0"},
       {"highest", "set Operation = maximum" + field + "Along = gap"},
       {"there", "set Operation = value at maximum\nset Field = code\nset Along = gap\n"
                 "set At = where"}});
  ASSERT_EQ(result.arrays.size(), 4U);
  for (const auto &quantity : result.arrays)
    EXPECT_EQ(quantity.axis, "frequency") << quantity.name;
}

TEST(Selection, CoordinatesThatAreNotThere) {
  const SmallAnalysis analysis = numbered();
  const std::string select = "set Operation = select\nset Field = code\nset Where = ";
  expect_parts(analysis.problem(select + "direction = up"), {"Where", "up", "forward, backward"});
  expect_parts(analysis.problem(select + "frequency = 2.1 Hz"), {"Where", "2.1 Hz", "2 Hz"});
  expect_parts(analysis.problem(select + "frequency = 2"), {"Where", "Hz"});
  expect_parts(analysis.problem(select + "gap = 1e-12"), {"Where", "gap"});
  expect_parts(analysis.problem(select + "time = 1 s"), {"Where", "time", "frequency"});
  expect_parts(analysis.problem(select + "direction"), {"Where", "'='"});
  EXPECT_EQ(analysis.problem(select + "gap = 0.1000000000001"), "");
}

} // namespace selection_tests
} // namespace vibroimpact::derived
