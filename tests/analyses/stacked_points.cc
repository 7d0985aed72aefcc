// Results as they are written: names below paths and in the summary; points as arrays, whose ragged
// inner dimensions and missing fields become NaN.
#include "analyses/results/stacked_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace vibroimpact::analyses {
namespace stacked_points_tests {

Field field(const std::string &name, std::vector<std::string> dimensions,
            std::vector<std::size_t> shape, std::vector<double> values) {
  return {.label = Label(name, "m", "text", std::move(dimensions)),
          .shape = std::move(shape),
          .values = std::move(values)};
}

TEST(StackedPointsTest, PutsPathsBeforeNamesAndDotsIntoTheSummary) {
  PointResult result;
  const FieldWriter contact = FieldWriter(result).below("contact/stop/");
  contact.number("gap/minimum", 1, "m", "smallest gap");
  contact.listed().number(Label("impacts", "1", "number"), 2);
  contact.line("impact[1]/force", 3, "N");
  contact.array({"map", "m", "rows", {"i", "j"}}, Matrix{{1, 2, 3}, {4, 5, 6}});
  ASSERT_EQ(result.fields.size(), 3u);
  EXPECT_EQ(find(result, "contact/stop/gap/minimum")->values, std::vector<double>{1});
  EXPECT_EQ(number_of(result, "contact/stop/impacts", 0), 2);
  EXPECT_EQ(number_of(result, "impacts", 7), 7);
  EXPECT_EQ(find(result, "impacts"), nullptr);
  EXPECT_THROW(field_of(result, "impacts"), std::out_of_range);
  const Field &map = field_of(result, "contact/stop/map");
  EXPECT_EQ(map.shape, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(map.values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  ASSERT_EQ(result.summary.size(), 2u);
  EXPECT_EQ(result.summary[0].name(), "contact.stop.impacts");
  EXPECT_EQ(result.summary[1].name(), "contact.stop.impact[1].force");
}

TEST(StackedPointsTest, OneDimensionMore) {
  const std::vector<PointResult> points = {
      {.index = {}, .fields = {field("a", {}, {}, {1}), field("b", {"i", "j"}, {2, 1}, {3, 4})}},
      {.index = {}, .fields = {field("b", {"i", "j"}, {1, 2}, {5, 6})}},
      {.index = {},
       .fields = {field("b", {"i", "j"}, {2, 2}, {1, 2, 3, 4}), field("a", {}, {}, {2})}}};
  PointResult all;
  add_stacked({all, "x/"}, points, "point");
  const std::vector<Field> &fields = all.fields;
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_EQ(fields[0].name(), "x/a");
  EXPECT_EQ(fields[0].unit(), "m");
  EXPECT_EQ(fields[0].dimensions(), (std::vector<std::string>{"point"}));
  EXPECT_EQ(fields[0].shape, (std::vector<std::size_t>{3}));
  EXPECT_EQ(fields[0].values[0], 1);
  EXPECT_TRUE(std::isnan(fields[0].values[1]));
  EXPECT_EQ(fields[0].values[2], 2);
  EXPECT_EQ(fields[1].dimensions(), (std::vector<std::string>{"point", "i", "j"}));
  EXPECT_EQ(fields[1].shape, (std::vector<std::size_t>{3, 2, 2}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> expected = {3, nan, 4, nan, 5, 6, nan, nan, 1, 2, 3, 4};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_TRUE(fields[1].values[i] == expected[i] ||
                (std::isnan(expected[i]) && std::isnan(fields[1].values[i])))
        << i;
}

TEST(StackedPointsTest, NoPointsHaveNoFields) {
  PointResult all;
  add_stacked(all, {}, "point");
  EXPECT_TRUE(all.fields.empty());
}

} // namespace stacked_points_tests
} // namespace vibroimpact::analyses
