// Pulses of measured force records, and the intervals of laws fitted to them.
#include "analyses/identification/identify.h"
#include "support/simulation_files.h"
#include "temporary_folder.h"

#include <fstream>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vibroimpact::analyses {
namespace measured_pulses_tests {

using testing::changed;
using testing::message_of;

MeasuredForce record(const std::vector<double> &force, double threshold, double interval = 1) {
  MeasuredForce measured{.samples = {.time = {}, .value = force}, .threshold = threshold};
  for (std::size_t i = 0; i < force.size(); ++i)
    measured.samples.time.push_back(interval * static_cast<double>(i));
  return measured;
}

TEST(MeasuredPulsesTest, PulsesAreSamplesAboveTheThresholdWithTheirNeighbours) {
  const auto pulses = pulses_of(record({0, 0.1, 3, 5, 0.2, 0, 0, 4, 0, 0}, 0.5, 2));
  ASSERT_EQ(pulses.size(), 2U);
  EXPECT_EQ(pulses[0].start, 4);
  EXPECT_EQ(pulses[0].duration, 2);
  EXPECT_EQ(pulses[0].samples, 2U);
  EXPECT_EQ(pulses[0].figures.peak_force, 5);
  EXPECT_NEAR(pulses[0].figures.impulse, 2 * (0.05 + 3 + 5 + 0.1), 1e-12);
  EXPECT_EQ(pulses[1].samples, 1U);
  EXPECT_EQ(pulses[1].duration, 0);
  EXPECT_NEAR(pulses[1].figures.impulse, 2 * 4, 1e-12);
}

TEST(MeasuredPulsesTest, PulsesThatTheRecordCutsAreLeftOut) {
  EXPECT_EQ(pulses_of(record({3, 0, 0, 4}, 1)).size(), 0U);
  EXPECT_EQ(pulses_of(record({3, 0, 2, 0, 4}, 1)).size(), 1U);
}

// A triggered recorder keeps only what is around pulses.
TEST(MeasuredPulsesTest, IntervalsMayDiffer) {
  MeasuredForce measured = record({0, 2, 0, 0, 6, 0}, 1);
  measured.samples.time = {0, 0.1, 0.3, 5, 5.2, 5.6};
  const auto pulses = pulses_of(measured);
  ASSERT_EQ(pulses.size(), 2U);
  EXPECT_NEAR(pulses[0].figures.impulse, 0.5 * 0.3 * 2, 1e-12);
  EXPECT_NEAR(pulses[1].figures.impulse, 0.5 * 0.6 * 6, 1e-12);
}

// The half sine: the sum of N samples over its length T is off by (pi / N)^2 / 12, its peak by
// less than (pi / 2N)^2 / 2.
TEST(MeasuredPulsesTest, ImpulseAndPeakConvergeWithTheSamples) {
  for (const int n : {10, 40, 160}) {
    std::vector<double> force{0, 0};
    for (int i = 0; i < n; ++i)
      force.push_back(100 * std::sin(std::numbers::pi * (i + 0.3) / n));
    force.insert(force.end(), {0, 0});
    const auto pulses = pulses_of(record(force, 1e-9, 1e-4 / n));
    ASSERT_EQ(pulses.size(), 1U);
    const double step = std::numbers::pi / n;
    EXPECT_NEAR(pulses[0].figures.impulse / (100 * 1e-4 * 2 / std::numbers::pi), 1,
                step * step / 4);
    EXPECT_NEAR(pulses[0].figures.peak_force / 100, 1, step * step / 8);
  }
}

// Of 400 sets of impacts with scattered restitution the intervals hold the law in 95 %, within four
// standard errors of so many draws.
TEST(MeasuredPulsesTest, IntervalsOfTheFittedLawHoldIt) {
  std::mt19937 random(1);
  std::normal_distribution<double> scatter(0, 0.05);
  std::uniform_real_distribution<double> speed(-2, 0.5);
  const int sets = 400;
  int coefficient = 0, exponent = 0;
  for (int set = 0; set < sets; ++set) {
    std::vector<Identified> impacts;
    for (int i = 0; i < 8; ++i) {
      const double v = std::exp(speed(random));
      impacts.push_back({.restitution = 0.5 * std::pow(v, -0.1) * std::exp(scatter(random)),
                         .approach_speed = v});
    }
    const PowerFit fit = fit_power(impacts, 1);
    coefficient += fit.coefficient_interval.low <= 0.5 && 0.5 <= fit.coefficient_interval.high;
    exponent += fit.exponent_interval.low <= -0.1 && -0.1 <= fit.exponent_interval.high;
  }
  const double four_errors = 4 * std::sqrt(0.95 * 0.05 / sets);
  EXPECT_NEAR(coefficient / double(sets), 0.95, four_errors);
  EXPECT_NEAR(exponent / double(sets), 0.95, four_errors);
}

TEST(MeasuredPulsesTest, TwoImpactsHaveNoInterval) {
  const PowerFit fit = fit_power(
      {{.restitution = 0.5, .approach_speed = 1}, {.restitution = 0.6, .approach_speed = 2}}, 1);
  EXPECT_NEAR(fit.coefficient, 0.5, 1e-12);
  EXPECT_TRUE(std::isnan(fit.coefficient_interval.low));
  EXPECT_TRUE(std::isnan(fit.exponent_interval.high));
}

const std::string sound = R"(
subsection Body a
  set Type = lumped
  subsection Mass head
    set Mass = 0.1 kg
    set Stiffness = 1 N/m
  end
end
subsection Contact heads
  set Between = a.head, stop
  set Direction = x
  set Clearance = 1 mm
  set Law = hertz
  subsection Hertz
    set Stiffness = 1e9 N/m^1.5
  end
end
subsection Analysis pulses
  set Type = identify
  subsection Identify
    set File = force.csv
    set Time column = t
    set Value column = f
    set Time unit = ms
    set Value unit = kN
    set Threshold = 50 N
  end
end
)";

class MeasuredPulsesFile : public ::testing::Test {
protected:
  MeasuredPulsesFile() {
    std::ofstream(folder_.path() / "force.csv") << "t,f\n0,0\n0.01,0.2\n0.02,0.3\n0.03,0\n";
  }
  std::string message(const std::string &from = "", const std::string &to = "") const {
    return message_of("set File folder = " + folder_.path().string() + changed(sound, from, to));
  }
  testing::TemporaryFolder folder_;
};

TEST_F(MeasuredPulsesFile, IsReadInItsUnits) {
  EXPECT_EQ(message(), "");
  const auto set = parameters::ParameterSet::parse(
      declare_parameters(), "set File folder = " + folder_.path().string() + sound, "test.prm",
      false);
  const MeasuredForce force =
      read_measured_force(set->root().instance("Analysis", "pulses").subsection("Identify"));
  EXPECT_NEAR(force.samples.time[1], 1e-5, 1e-18);
  EXPECT_NEAR(force.samples.value[2], 300, 1e-12);
  EXPECT_NEAR(pulses_of(force).at(0).figures.impulse, 5e-3, 1e-15);
}

TEST_F(MeasuredPulsesFile, WhatCannotBeUsedIsNamed) {
  const struct {
    std::string from, to;
    std::vector<std::string> words;
  } mistakes[] = {
      {"Value column = f", "Value column = g", {"Identify / Value column", "t, f"}},
      {"File = force.csv", "File = none.csv", {"Identify / File", "can be read"}},
      {"Value unit = kN", "Value unit = kg", {"Identify / Value unit"}},
      {"Time unit = ms", "Time unit = mm", {"Identify / Time unit"}},
      {"Threshold = 50 N",
       "Threshold = 900 N",
       {"Identify / Threshold", "none of which is a pulse"}},
      {"    set Threshold = 50 N\n", "", {"Identify / Threshold", "must be given"}},
      {"set File = force.csv",
       "set File = force.csv\nset Duration = 1 s",
       {"Identify / Duration", "when File is set"}},
      {"set File = force.csv\n",
       "set Duration = 1 s\n",
       {"Identify / Time column", "when File is not set"}},
  };
  for (const auto &[from, to, words] : mistakes) {
    const std::string text = message(from, to);
    for (const std::string &word : words)
      EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
  }
}

} // namespace measured_pulses_tests
} // namespace vibroimpact::analyses
