// One motion that settles and is recorded: by cycles, by time, and what it needs for that.
#include "analyses/sweeps/steady_state.h"

#include "common/error.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace vibroimpact::analyses {
namespace steady_state_tests {

using namespace model;
using testing::value_of;

constexpr double pi = std::numbers::pi;
constexpr double mass = 1, stiffness = 400, damping = 6, omega = 15, force = 2;

/// Keeps the one point.
class OnePoint : public LineContext {
public:
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return known ? &result : nullptr;
  }
  void store(PointResult stored) override { result = std::move(stored); }
  void skip() override { skipped = true; }

  PointResult result;
  bool known = false;
  bool skipped = false;
};

System oscillator(double factor = 1, double frequency = omega) {
  Model model({testing::single_mass("block", mass, stiffness, factor * damping)});
  model.add_force("push", std::make_shared<Harmonic>(Given::displacement, force, frequency, 0), {},
                  Vector3::UnitX());
  return testing::system_of(std::move(model));
}

SteadyState::Settings by_cycles(long longest) {
  return {.settling = {.minimum = 5, .maximum = longest, .tolerance = 1e-6, .longest_multiple = 4},
          .cycles = 3,
          .excitation = {}};
}

PointResult run(const SteadyState::Settings &settings, System system) {
  OnePoint point;
  SteadyState(settings).run_line(0, system, point);
  return point.result;
}

double amplitude() {
  return force / std::abs(std::complex<double>(stiffness - mass * omega * omega, omega * damping));
}

const std::string excursion = "point/block.head/displacement_x/peak_to_peak";

TEST(SteadyStateTest, SettlesByCyclesUntilItIsSteady) {
  const PointResult result = run(by_cycles(500), oscillator());
  EXPECT_EQ(value_of(result, "steady"), 1);
  EXPECT_EQ(value_of(result, "period_multiple"), 1);
  EXPECT_LT(value_of(result, "settling_cycles"), 100);
  EXPECT_NEAR(value_of(result, excursion), 2 * amplitude(), 3e-6 * amplitude());
}

TEST(SteadyStateTest, GoesStraightToThePeriodicMotion) {
  SteadyState::Settings settings = by_cycles(500);
  settings.settling.newton_after = 2;
  const PointResult result = run(settings, oscillator(0.1));
  EXPECT_EQ(value_of(result, "steady"), 1);
  EXPECT_EQ(value_of(result, "period_multiple"), 1);
  EXPECT_LT(value_of(result, "settling_cycles"), 60);
  const double high = force / std::abs(std::complex<double>(stiffness - mass * omega * omega,
                                                            0.1 * omega * damping));
  EXPECT_NEAR(value_of(result, excursion), 2 * high, 1e-9 * high);
}

TEST(SteadyStateTest, RecordsWhatIsNotSteadyAsWell) {
  const PointResult result = run(by_cycles(6), oscillator(0.01));
  EXPECT_EQ(value_of(result, "steady"), 0);
  EXPECT_EQ(value_of(result, "settling_cycles"), 6);
  EXPECT_EQ(result.status, Status::finished);
}

// From rest, x = A Im(exp(i w t)) less its own start as a free motion: the largest value of the
// first instants comes from that, not from the steady motion.
TEST(SteadyStateTest, SettlesAndRecordsByTime) {
  SteadyState::Settings settings;
  settings.by_time = true;
  settings.settling_time = 10;
  settings.recorded_time = 4 * pi / omega;
  EXPECT_NEAR(value_of(run(settings, oscillator()), excursion), 2 * amplitude(),
              1e-7 * amplitude());
  settings.settling_time = 0;
  settings.recorded_time = 0.01; // x = F w t^3 / 6 m at first
  EXPECT_NEAR(value_of(run(settings, oscillator()), excursion), force * omega * 1e-6 / (6 * mass),
              0.05 * force * omega * 1e-6 / (6 * mass));
}

TEST(SteadyStateTest, CyclesNeedAPeriod) {
  System system = oscillator();
  system.model.add_force("more", std::make_shared<Harmonic>(Given::displacement, 1, 2, 0), {},
                         Vector3::UnitX());
  SteadyState::Settings settings = by_cycles(10);
  EXPECT_THROW(SteadyState(settings).check(system), InputError);
  settings.excitation = "pull";
  EXPECT_THROW(SteadyState(settings).check(system), InputError);
  settings.excitation = "more";
  EXPECT_NO_THROW(SteadyState(settings).check(system));
}

TEST(SteadyStateTest, AKnownPointIsNotComputedAgain) {
  OnePoint point;
  point.known = true;
  System system = oscillator();
  SteadyState(by_cycles(10)).run_line(0, system, point);
  EXPECT_TRUE(point.skipped);
}

} // namespace steady_state_tests
} // namespace vibroimpact::analyses
