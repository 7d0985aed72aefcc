// Results without units: factors, texts.
#include "derived/dimensionless.h"
#include "derived/units_of_fields.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vibroimpact::derived {
namespace dimensionless_tests {

constexpr double two_pi = 2 * std::numbers::pi;

TEST(Dimensionless, only_frequencies_change) {
  EXPECT_DOUBLE_EQ(plain_factor("Hz"), two_pi);
  EXPECT_DOUBLE_EQ(plain_factor("1/(Hz)"), 1 / two_pi);
  for (const char *unit : {"1", "m", "N s/m", "1/s", "rad/s", "N/m^1.5", "kg m^2", "1/(N/m)", "W"})
    EXPECT_EQ(plain_factor(unit), 1) << unit;
}

TEST(Dimensionless, fractions_are_units) {
  EXPECT_EQ(one("1/s").dimension, parameters::dimension::inverse_time);
  EXPECT_EQ(one("m/(rad/s)").dimension,
            (parameters::Dimension{.length = 1, .time = 1, .angle = -1}));
}

TEST(Dimensionless, descriptions_lose_their_units) {
  EXPECT_EQ(plain_description("displacement [m] or rotation [rad] of a node"),
            "displacement or rotation of a node");
  EXPECT_EQ(plain_description("approach speed"), "approach speed");
  EXPECT_EQ(plain_description("from [a"), "from [a");
}

TEST(Dimensionless, axes_and_fields_are_in_the_units_of_the_file) {
  AnalysisHeader header{.name = "curve", .type = "stepped sweep", .axes = {}};
  header.axes.push_back(
      {"frequency", {0.5 / two_pi, 1 / two_pi}, {}, "Hz", "excitation frequency"});
  header.axes.push_back({"direction", {}, {"forward", "backward"}, "1", "direction"});
  remove_units(header);
  EXPECT_DOUBLE_EQ(header.axes[0].values[0], 0.5);
  EXPECT_EQ(header.axes[0].unit, "1");
  EXPECT_EQ(header.axes[0].description, "excitation frequency, angular");
  EXPECT_EQ(header.axes[1].labels.size(), 2U);

  AnalysisArrays arrays;
  arrays.fields.push_back(
      {.label = Label("gap", "m", "gap [m] of a contact", {"time"}), .values = {0.25}});
  arrays.fields.push_back({.label = Label("peak", "Hz", "resonance"), .values = {1}});
  remove_units(arrays);
  EXPECT_EQ(arrays.fields[0].label, Label("gap", "1", "gap of a contact", {"time"}));
  EXPECT_EQ(arrays.fields[0].values[0], 0.25);
  EXPECT_EQ(arrays.fields[1].label, Label("peak", "1", "resonance, angular"));
  EXPECT_DOUBLE_EQ(arrays.fields[1].values[0], two_pi);
}

} // namespace dimensionless_tests
} // namespace vibroimpact::derived
