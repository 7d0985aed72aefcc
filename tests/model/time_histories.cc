// Time histories: closed forms, derivatives, breaks, and the closed form each gives of itself.
#include "model/piecewise_function.h"
#include "model/pulse.h"
#include "model/ramped_harmonic.h"
#include "model/recorded_history.h"
#include "model/sine_sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace vibroimpact::model {
namespace time_histories_tests {

using std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct NamedHistory {
  std::string name;
  TimeFunctionPointer function;
};

SweepDefinition sweep_definition(Given given, bool logarithmic) {
  return {.given = given,
          .amplitude = 1.3,
          .phase = 0.4,
          .from = 2 * pi,
          .to = 6 * pi,
          .duration = 4,
          .logarithmic = logarithmic};
}

const Samples record{.time = {0.25, 0.5, 1, 1.125, 2}, .value = {0, 1.5, -0.75, 0.5, 0.25}};

std::vector<NamedHistory> all_histories() {
  std::vector<NamedHistory> list;
  for (const Given given : {Given::displacement, Given::velocity, Given::acceleration}) {
    const std::string of = " of derivative " + std::to_string(static_cast<int>(given));
    list.push_back({"harmonic" + of, std::make_shared<Harmonic>(given, 2.5, 7, 0.3)});
    list.push_back({"ramp" + of, std::make_shared<RampedHarmonic>(given, 2.5, 7, 0.3, 1.5)});
    list.push_back({"constant" + of, make_constant(given, -1.5)});
    for (const bool logarithmic : {false, true}) {
      SweepDefinition sweep = sweep_definition(given, logarithmic);
      list.push_back({"sweep" + of, std::make_shared<SineSweep>(sweep)});
      sweep.fade_in = 0.75;
      sweep.fade_out = 1.5;
      sweep.hold = false;
      list.push_back({"faded sweep" + of, std::make_shared<SineSweep>(sweep)});
    }
    for (const PulseShape shape : {PulseShape::rectangular, PulseShape::half_sine,
                                   PulseShape::triangular, PulseShape::versed_sine})
      list.push_back({"pulse" + of, make_pulse(given, shape, 2, 0.5, 0.75)});
    for (const auto interpolation : {Interpolation::linear, Interpolation::cubic_spline})
      list.push_back(
          {"record" + of, make_recorded(given, record, interpolation,
                                        given == Given::acceleration ? OutsideRecord::zero
                                                                     : OutsideRecord::held)});
  }
  return list;
}

// Central difference of sixth order; its error is far below the tolerance for the step used.
double difference(const std::function<double(double)> &f, double t, double h) {
  return (45 * (f(t + h) - f(t - h)) - 9 * (f(t + 2 * h) - f(t - 2 * h)) +
          (f(t + 3 * h) - f(t - 3 * h))) /
         (60 * h);
}

// Instants inside the smooth pieces of a function, none nearer to a break than 0.01.
std::vector<double> smooth_instants(const TimeFunction &function) {
  std::vector<double> instants;
  for (double t = -0.4137; t < 5; t += 0.0731)
    if (function.next_break(t - 0.01) > t + 0.01)
      instants.push_back(t);
  return instants;
}

TEST(TimeHistoriesTest, RateAndAccelerationAreTheDerivatives) {
  for (const auto &[name, function] : all_histories())
    for (const double t : smooth_instants(*function)) {
      const auto value = [&](double at) { return function->value(at); };
      const auto rate = [&](double at) { return function->rate(at); };
      EXPECT_NEAR(function->rate(t), difference(value, t, 1e-3), 2e-9) << name << " at " << t;
      EXPECT_NEAR(function->acceleration(t), difference(rate, t, 1e-3), 2e-7)
          << name << " at " << t;
    }
}

// Where the closed form exists it is the function, and it holds up to the next break.
TEST(TimeHistoriesTest, ClosedFormIsTheFunction) {
  for (const auto &[name, function] : all_histories())
    for (const double t : {-0.5, 0.0, 0.3, 0.5, 0.9, 1.25, 4.0, 6.0}) {
      const std::optional<ExponentialForm> form = function->exponential_form(t);
      if (!form) {
        EXPECT_TRUE(name.find("sweep") != std::string::npos && t >= 0 && t < 4) << name;
        continue;
      }
      EXPECT_EQ(form->origin, t);
      const double end = std::min(function->next_break(t), t + 1);
      for (const double part : {0.0, 0.3, 0.999}) {
        const double at = t + part * (end - t);
        EXPECT_NEAR(form->value(at), function->value(at), 1e-12) << name << " at " << at;
        EXPECT_NEAR(form->rate(at), function->rate(at), 1e-12) << name << " at " << at;
        EXPECT_NEAR(form->acceleration(at), function->acceleration(at), 1e-11) << name;
      }
    }
}

// Between breaks no jump; displacement and velocity of a moved base never jump at all.
TEST(TimeHistoriesTest, IntegralsAreContinuousAtBreaks) {
  for (const auto &[name, function] : all_histories()) {
    if (name.find("of derivative 2") == std::string::npos)
      continue;
    double t = -1;
    while ((t = function->next_break(t)) < infinity) {
      const double before = std::nextafter(t, -infinity);
      EXPECT_NEAR(function->value(t), function->value(before), 1e-13) << name << " at " << t;
      EXPECT_NEAR(function->rate(t), function->rate(before), 1e-13) << name << " at " << t;
    }
  }
}

TEST(TimeHistoriesTest, BreaksAreFoundOneAfterTheOther) {
  const auto pulse = make_pulse(Given::displacement, PulseShape::triangular, 1, 0.5, 1);
  EXPECT_EQ(pulse->next_break(0), 0.5);
  EXPECT_EQ(pulse->next_break(0.5), 1.0);
  EXPECT_EQ(pulse->next_break(1.2), 1.5);
  EXPECT_EQ(pulse->next_break(1.5), infinity);
  EXPECT_EQ(Harmonic(Given::displacement, 1, 1, 0).next_break(0), infinity);
  EXPECT_EQ(SineSweep(sweep_definition(Given::velocity, true)).next_break(0), 4);
  EXPECT_EQ(pulse->value(std::nextafter(0.5, 0)), 0);
}

TEST(TimeHistoriesTest, RampIsTheGivenQuantity) {
  for (const Given given : {Given::displacement, Given::velocity, Given::acceleration}) {
    const RampedHarmonic ramp(given, 0.02, 9, 0.7, 2.5);
    for (const double t : {0.0, 0.1, 0.7, 3.0}) {
      const double is = given == Given::displacement ? ramp.value(t)
                        : given == Given::velocity   ? ramp.rate(t)
                                                     : ramp.acceleration(t);
      EXPECT_NEAR(is, 0.02 * (1 - std::exp(-2.5 * t)) * std::sin(9 * t + 0.7), 1e-15);
    }
    // No drift: it ends as the harmonic about zero.
    const Harmonic harmonic(given, 0.02, 9, 0.7);
    EXPECT_NEAR(ramp.value(40), harmonic.value(40), 1e-14);
    EXPECT_NEAR(ramp.with_frequency(4)->value(40), harmonic.with_frequency(4)->value(40), 1e-14);
  }
}

TEST(TimeHistoriesTest, PulsesHaveTheirArea) {
  for (const PulseShape shape : {PulseShape::rectangular, PulseShape::half_sine,
                                 PulseShape::triangular, PulseShape::versed_sine}) {
    // The velocity after a pulse of acceleration is the area under it.
    const auto pulse = make_pulse(Given::acceleration, shape, 3, 0.5, 0.2);
    EXPECT_NEAR(pulse->rate(2), area_factor(shape) * 3 * 0.2, 1e-15);
    EXPECT_NEAR(pulse->acceleration(0.6), 3, shape == PulseShape::triangular ? 1e-13 : 1e-14);
    EXPECT_EQ(pulse->acceleration(0.7), 0);
  }
}

TEST(TimeHistoriesTest, SweepRunsFromOneFrequencyToTheOther) {
  for (const bool logarithmic : {false, true}) {
    const SweepDefinition definition = sweep_definition(Given::displacement, logarithmic);
    const SineSweep sweep(definition);
    const double middle = logarithmic ? 2 * pi * std::sqrt(3) : 4 * pi;
    EXPECT_NEAR(sweep.frequency(2), middle, 1e-12);
    EXPECT_NEAR(sweep.frequency(4), 6 * pi, 1e-12);
    // The number of radians is the mean frequency times the duration.
    const double mean = logarithmic ? 4 * pi / std::log(3) : 4 * pi;
    EXPECT_NEAR(sweep.phase(4) - 0.4, mean * 4, 1e-11);
    // phase' = omega
    EXPECT_NEAR(difference([&](double t) { return sweep.phase(t); }, 1.7, 1e-3),
                sweep.frequency(1.7), 1e-9);
    EXPECT_NEAR(sweep.value(1.7), 1.3 * std::sin(sweep.phase(1.7)), 1e-14);
    // It goes on without a jump at the last frequency.
    EXPECT_NEAR(sweep.value(5), 1.3 * std::sin(mean * 4 + 0.4 + 6 * pi), 1e-12);
    EXPECT_NEAR(sweep.value(4), sweep.value(std::nextafter(4, 0)), 1e-12);
  }
}

// Of a linear sweep from standstill at phase 0 the integral of the velocity is a Fresnel integral:
// S(1) = 0.438259147390354766... (Abramowitz and Stegun, table 7.8).
TEST(TimeHistoriesTest, IntegralOfALinearSweepIsAFresnelIntegral) {
  SweepDefinition definition{
      .given = Given::velocity, .amplitude = 1, .from = 1e-9, .to = pi, .duration = 1};
  const SineSweep sweep(definition);
  EXPECT_NEAR(sweep.value(std::nextafter(1, 0)) - sweep.value(0), 0.43825914739035477, 2e-9);
  // and ends where the harmonic it turns into swings about zero
  EXPECT_NEAR(sweep.value(1), -std::cos(sweep.phase(1)) / sweep.frequency(1), 1e-15);
}

// Slow sweeps of acceleration: the displacement stays near that of the harmonic. What it differs by
// is 3 omega' / omega^4 there and at the start, 7.5e-6 each; a velocity left over would add up to
// far more in 400 s.
TEST(TimeHistoriesTest, SweptAccelerationDoesNotDrift) {
  for (const bool logarithmic : {false, true}) {
    const SineSweep sweep({.given = Given::acceleration,
                           .amplitude = 1,
                           .from = 10,
                           .to = 20,
                           .duration = 400,
                           .logarithmic = logarithmic});
    for (double t = 0; t < 400; t += 0.37) {
      const double omega = sweep.frequency(t);
      EXPECT_NEAR(sweep.value(t), -std::sin(sweep.phase(t)) / (omega * omega), 2e-5);
    }
  }
}

// The phase goes on without a jump.
TEST(TimeHistoriesTest, AfterASweepTheSineGoesOnAtTheLastFrequency) {
  for (const bool logarithmic : {false, true}) {
    const SineSweep sweep(sweep_definition(Given::displacement, logarithmic));
    for (double t = 4; t < 5; t += 0.07)
      EXPECT_NEAR(sweep.value(t), 1.3 * std::sin(sweep.phase(4) + 6 * pi * (t - 4)), 1e-12) << t;
  }
}

TEST(TimeHistoriesTest, FadedSweepBeginsAndEndsAtRest) {
  SweepDefinition definition = sweep_definition(Given::displacement, false);
  definition.fade_in = definition.fade_out = 1;
  definition.hold = false;
  const SineSweep sweep(definition);
  for (const double t : {0.0, std::nextafter(4.0, 0.0), 4.0, 5.0}) {
    EXPECT_NEAR(sweep.value(t), 0, 1e-14);
    EXPECT_NEAR(sweep.rate(t), 0, 1e-11);
    EXPECT_NEAR(sweep.acceleration(t), 0, 1e-10);
  }
  EXPECT_NEAR(sweep.value(2), 1.3 * std::sin(sweep.phase(2)), 1e-14);
}

TEST(TimeHistoriesTest, RecordsPassThroughTheirSamples) {
  for (const auto interpolation : {Interpolation::linear, Interpolation::cubic_spline}) {
    const auto history =
        make_recorded(Given::displacement, record, interpolation, OutsideRecord::zero);
    for (std::size_t i = 0; i + 1 < record.time.size(); ++i)
      EXPECT_NEAR(history->value(record.time[i]), record.value[i], 1e-15);
    EXPECT_EQ(history->value(0.2), 0);
    EXPECT_EQ(history->value(2), 0);
    EXPECT_NEAR(history->value(std::nextafter(2, 0)), 0.25, 1e-14);
  }
  const auto line =
      make_recorded(Given::displacement, record, Interpolation::linear, OutsideRecord::held);
  EXPECT_NEAR(line->value(0.75), 0.375, 1e-15);
  EXPECT_EQ(line->value(0), 0);
  EXPECT_EQ(line->value(7), 0.25);
}

// Samples a time h apart tell nothing above their Nyquist frequency, pi / h; the shortest h counts.
TEST(TimeHistoriesTest, HighestFrequencyOfARecord) {
  const auto history =
      make_recorded(Given::displacement, record, Interpolation::linear, OutsideRecord::zero);
  EXPECT_DOUBLE_EQ(history->highest_frequency(), pi / 0.125);
}

// Acceleration 0, 3, 0 at t = 0, 1, 2: velocity 3 and displacement 3 at t = 2, by hand.
TEST(TimeHistoriesTest, RecordedAccelerationIsIntegratedExactly) {
  const auto motion = make_recorded(Given::acceleration, {.time = {0, 1, 2}, .value = {0, 3, 0}},
                                    Interpolation::linear, OutsideRecord::zero);
  EXPECT_DOUBLE_EQ(motion->rate(1), 1.5);
  EXPECT_DOUBLE_EQ(motion->value(1), 0.5);
  EXPECT_DOUBLE_EQ(motion->rate(2), 3);
  EXPECT_DOUBLE_EQ(motion->value(2), 3);
  EXPECT_DOUBLE_EQ(motion->value(4), 9);
}

// A spline with end slopes zero of a function with end slopes zero converges with order four.
TEST(TimeHistoriesTest, SplineIsSmoothAndOfFourthOrder) {
  const auto error = [](int intervals) {
    Samples samples;
    for (int i = 0; i <= intervals; ++i) {
      samples.time.push_back(2 * pi * i / intervals);
      samples.value.push_back(std::cos(samples.time.back()));
    }
    const auto spline = make_recorded(Given::displacement, samples, Interpolation::cubic_spline,
                                      OutsideRecord::held);
    for (int i = 1; i < intervals; ++i) {
      const double at = samples.time[i];
      EXPECT_NEAR(spline->acceleration(at), spline->acceleration(std::nextafter(at, 0)), 1e-11);
    }
    double worst = 0;
    for (double t = 0.01; t < 2 * pi; t += 0.01)
      worst = std::max(worst, std::abs(spline->value(t) - std::cos(t)));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(20) / error(40)), 4, 0.2);
}

// Right after its start a pulse of a base's acceleration moves it by a power of the time t since
// then, to all digits: A w t^3 / 6 of a half sine, A w^2 t^4 / 48 of a versed sine.
TEST(TimeHistoriesTest, PulsesBeginLikePowersOfTime) {
  constexpr double start = 0.4375, duration = 0.5, peak = 3;
  for (const int exponent : {-50, -30, -20, -12}) {
    const double t = std::ldexp(1, exponent);
    const double half = pi / duration;
    const auto half_sine =
        make_pulse(Given::acceleration, PulseShape::half_sine, peak, start, duration);
    const double x = half * t;
    EXPECT_NEAR(half_sine->value(start + t) / (peak * half * t * t * t / 6), 1, x * x / 20 + 1e-14);
    EXPECT_NEAR(half_sine->rate(start + t) / (peak * half * t * t / 2), 1, x * x / 12 + 1e-14);
    const auto versed =
        make_pulse(Given::acceleration, PulseShape::versed_sine, peak, start, duration);
    const double y = 2 * x;
    const double acceleration = peak * half * half * t * t;
    EXPECT_NEAR(versed->acceleration(start + t) / acceleration, 1, y * y / 12 + 1e-14);
    EXPECT_NEAR(versed->value(start + t) / (acceleration * t * t / 12), 1, y * y / 30 + 1e-14);
  }
}

} // namespace time_histories_tests
} // namespace vibroimpact::model
