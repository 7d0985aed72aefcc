// Extreme values of sums of exponentials: as dense samples show them, and in closed form.
#include "motion/path/exact_outputs.h"
#include "common/signals.h"
#include "exponential_sums.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vibroimpact::motion {
namespace exact_outputs_tests {

// One form of a phase made of given exponentials.
struct Output {
  std::vector<Complex> exponents, coefficients, amplitudes;
  double constant = 0;
  bool differentiated = false;

  explicit Output(std::vector<Complex> list)
      : exponents(std::move(list)), coefficients(exponents.size()), amplitudes(exponents.size()) {}

  double operator()(double t) const {
    double value = differentiated ? 0 : constant;
    for (std::size_t j = 0; j < exponents.size(); ++j) {
      const Complex factor = differentiated ? exponents[j] : Complex(1);
      value += (coefficients[j] * factor * amplitudes[j] * std::exp(exponents[j] * t)).real();
    }
    return value;
  }

  // The guard is far away; the outputs are the sum of the products as amplitudes of 1.
  Sum sum() const {
    Sum sum{.constant = 1e300, .coefficients = coefficients, .exponents = exponents};
    for (std::size_t j = 0; j < exponents.size(); ++j)
      sum.coefficients[j] *= amplitudes[j];
    return sum;
  }

  LinearForm form() const {
    const Sum seen = sum();
    std::vector<double> row;
    for (std::size_t j = 0; j < exponents.size(); ++j) {
      row.push_back(seen.coefficients[j].real());
      if (exponents[j].imag() != 0)
        row.push_back(-seen.coefficients[j].imag());
    }
    return {.row = {.row = Eigen::Map<RowVector>(row.data(), static_cast<Index>(row.size())),
                    .constant = constant},
            .differentiated = differentiated};
  }

  // The ranges of the forms grow.
  void observe(const LinearOutputs &forms, double h, std::size_t outputs_of_all) const {
    SumsPhase phase({sum()});
    ExactOutputs outputs(forms, *phase.phase);
    EXPECT_EQ(outputs.size(), outputs_of_all);
    const Amplitudes start = phase.amplitudes();
    EXPECT_EQ(phase.advance(kernel(), h), MarchEnd::limit);
    outputs.include(start.data(), phase.walk.amplitudes, h);
    pieces = outputs.pieces();
  }

  mutable long pieces = 0; ///< that the last search has examined

  ValueRange extent_over(double h) const {
    ValueRange range;
    LinearOutputs forms;
    forms.add(form(), range);
    observe(forms, h, 1);
    return range;
  }
};

// 1 + cos(3 t) over four and a half turns, and its derivative.
TEST(ExactOutputsTest, Vibration) {
  Output sum({Complex(0, 3)});
  sum.amplitudes[0] = sum.coefficients[0] = 1;
  sum.constant = 1;
  const double h = 9.5;
  ValueRange range = sum.extent_over(h);
  EXPECT_NEAR(range.maximum, 2, 1e-14);
  EXPECT_NEAR(range.minimum, 0, 1e-14);
  sum.differentiated = true;
  range = sum.extent_over(h);
  EXPECT_NEAR(range.maximum, 3, 1e-14);
  EXPECT_NEAR(range.minimum, -3, 1e-14);
}

// exp(-t) - exp(-3 t) has its largest value 2/3^1.5 at t = ln(3)/2 and none before.
TEST(ExactOutputsTest, Decay) {
  Output sum({-1.0, -3.0});
  sum.amplitudes = {1, 1};
  sum.coefficients = {1, -1};
  EXPECT_NEAR(sum.extent_over(5).maximum, 2 / std::pow(3, 1.5), 1e-15);
  EXPECT_NEAR(sum.extent_over(0.5).maximum, std::exp(-0.5) - std::exp(-1.5), 1e-15);
}

// A decay a million times faster than the vibration is over at once and costs nothing later.
TEST(ExactOutputsTest, FastDecayBesideAVibration) {
  Output sum({Complex(0, 1), -1e6});
  sum.amplitudes = {1, 5};
  sum.coefficients = {1, 1};
  const ValueRange range = sum.extent_over(20);
  EXPECT_NEAR(range.maximum, 6, 1e-14);
  EXPECT_NEAR(range.minimum, -1, 1e-14);
}

// 2 cos(t) - 2 r (exp(-t) - exp(-b t) / b) with r = b / (b - 1): at the start the form and its
// slope are zero while those of its terms are not, as of a body at rest behind a strong dashpot.
TEST(ExactOutputsTest, DecaysThatCancelAtTheStart) {
  for (const double fast : {1.5, 4.0, 100.0, 1e8}) {
    Output sum({Complex(0, 1), -1.0, -fast});
    const double ratio = fast / (fast - 1);
    sum.amplitudes = {2, 1, 1};
    sum.coefficients = {1, -2 * ratio, 2 * ratio / fast};
    const ValueRange range = sum.extent_over(0.01);
    EXPECT_NEAR(range.minimum, std::min(0.0, sum(0.01)), 1e-14) << fast;
    EXPECT_LT(sum.pieces, 300) << fast;
  }
}

// exp(-a t) - exp(-b t) beside a vibration, from soft to rigid and from equal to far apart.
TEST(ExactOutputsTest, WorkDoesNotGrowWithADecay) {
  for (double fast = 1e-3; fast < 1e13; fast *= 3)
    for (const double other : {1 + 1e-9, 1 + 1e-3, 2.0, 1e4}) {
      Output sum({Complex(0, 1), -fast, -fast * other});
      sum.amplitudes = {1, 1, 1};
      sum.coefficients = {0.3, 1, -1};
      const double top = std::log(other) / (fast * (other - 1)); // of the two decays
      const double h = 3;
      const ValueRange range = sum.extent_over(h);
      EXPECT_LT(sum.pieces, 400) << fast << ' ' << other;
      EXPECT_GE(range.maximum, sum(std::min(top, h)) - 1e-14) << fast << ' ' << other;
      EXPECT_LE(range.minimum, sum(h) + 1e-14);
    }
}

// A long vibration is searched in many pieces, and left where the run is to stop.
TEST(ExactOutputsTest, SearchObeysARequestToStop) {
  Output sum({Complex(0, 3)});
  sum.amplitudes[0] = sum.coefficients[0] = 1;
  signals::set_limit_reached(true);
  EXPECT_THROW(sum.extent_over(1000), Interrupted);
  signals::set_limit_reached(false);
  EXPECT_NEAR(sum.extent_over(1000).maximum, 1, 1e-14);
}

TEST(ExactOutputsTest, AConstantOverAnyLength) {
  Output sum({0.0});
  sum.amplitudes[0] = 2;
  sum.coefficients[0] = 1;
  for (const double h : {1e-300, 1.0, 1e150}) {
    const ValueRange range = sum.extent_over(h);
    EXPECT_EQ(range.minimum, 2);
    EXPECT_EQ(range.maximum, 2);
  }
}

// Samples lie within the range, and the range within what samples can miss of it.
TEST(ExactOutputsTest, RandomSumsAndSamples) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Complex> exponents;
    for (int j = 0; j < 1 + trial % 6; ++j)
      exponents.emplace_back(-uniform(random) + (trial % 3 == 0 ? 0.5 : 0.0),
                             j % 3 == 2 ? 0.0 : std::exp(3 * uniform(random)));
    Output sum(exponents);
    sum.differentiated = trial % 2 == 1;
    sum.constant = normal(random);
    double curvature = 0;
    const double h = 3 * uniform(random);
    for (std::size_t j = 0; j < exponents.size(); ++j) {
      const bool pair = exponents[j].imag() != 0;
      sum.amplitudes[j] = {normal(random), pair ? normal(random) : 0};
      sum.coefficients[j] = {normal(random), pair ? normal(random) : 0};
      curvature += 30 * std::pow(std::abs(exponents[j]), 3) + 1;
    }
    const ValueRange range = sum.extent_over(h);
    double lowest = sum(0);
    double highest = lowest;
    constexpr int samples = 4000;
    for (int i = 0; i <= samples; ++i) {
      lowest = std::min(lowest, sum(h * i / samples));
      highest = std::max(highest, sum(h * i / samples));
    }
    const double missed = curvature * 8 * (h / samples) * (h / samples);
    EXPECT_LE(range.minimum, lowest + 1e-12 * (1 + std::abs(lowest))) << trial;
    EXPECT_GE(range.maximum, highest - 1e-12 * (1 + std::abs(highest))) << trial;
    EXPECT_GE(range.minimum, lowest - missed) << trial;
    EXPECT_LE(range.maximum, highest + missed) << trial;
  }
}

// 1 + cos(3 t) and 1/2 - 5/2 cos(3 t): one output. A range that has seen more keeps it, and takes
// nothing from one that has not.
TEST(ExactOutputsTest, ParallelFormsAreOneOutput) {
  Output sum({Complex(0, 3)});
  sum.amplitudes[0] = sum.coefficients[0] = 1;
  sum.constant = 1;
  ValueRange whole;
  ValueRange turned;
  ValueRange wider{.minimum = -7, .maximum = 0.5};
  ValueRange rate;
  LinearForm other = sum.form();
  other.row.row *= -2.5;
  other.row.constant = 0.5;
  LinearOutputs forms;
  forms.add(sum.form(), whole);
  forms.add(other, turned);
  forms.add(sum.form(), wider);
  sum.differentiated = true;
  forms.add(sum.form(), rate);
  sum.observe(forms, 9.5, 2);
  EXPECT_NEAR(whole.minimum, 0, 1e-14);
  EXPECT_NEAR(whole.maximum, 2, 1e-14);
  EXPECT_NEAR(turned.minimum, -2, 1e-14);
  EXPECT_NEAR(turned.maximum, 3, 1e-14);
  EXPECT_EQ(wider.minimum, -7);
  EXPECT_NEAR(wider.maximum, 2, 1e-14);
  EXPECT_NEAR(rate.minimum, -3, 1e-14);
  EXPECT_NEAR(rate.maximum, 3, 1e-14);
}

// Displacement of one body.
class Watch : public Observer {
public:
  Watch(const model::Model &model, std::size_t body)
      : form_(PointForm{model.displacement({.body = body, .point = 0}, Vector3::UnitX(), false)}) {}
  void outputs(const Equations & /*equations*/, std::vector<motion::Output> &list) override {
    list.push_back({&form_, &range});
  }
  bool sees_steps(const Equations & /*equations*/) const override { return false; }
  ValueRange range;

private:
  OutputForm form_;
};

// Two bodies vibrate with amplitudes 1 and 3: what one observer has asked for is not what the next
// one sees.
TEST(ExactOutputsTest, EachObserverSeesItsOwnOutputs) {
  const model::Model model(
      {testing::single_mass("a", 1, 4, 0), testing::single_mass("b", 1, 9, 0)});
  const contact::ContactSet none;
  Trajectory trajectory(model, none, {});
  Vector start(2);
  start << 1, 3;
  trajectory.start(0, start, Vector::Zero(2));
  for (const std::size_t body : {0, 1}) {
    Watch watch(model, body);
    trajectory.advance(trajectory.time() + 10, watch);
    const double amplitude = start[static_cast<Index>(body)];
    EXPECT_NEAR(watch.range.maximum, amplitude, 1e-12) << body;
    EXPECT_NEAR(watch.range.minimum, -amplitude, 1e-12) << body;
  }
}

// Driven in resonance, q'' + 4 q = sin(2 t): q = (sin(2 t) - 2 t cos(2 t)) / 8 turns at k pi / 2.
TEST(ExactOutputsTest, Resonance) {
  model::Model model({testing::single_mass("mass", 1, 4, 0)});
  model.add_force("force", std::make_shared<model::Harmonic>(model::Given::displacement, 1, 2, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const contact::ContactSet none;
  Trajectory trajectory(model, none, {});
  constexpr double pi = std::numbers::pi;
  for (int turns = 2; turns < 12; ++turns)
    for (const double beyond : {0.1, 0.5, 0.9}) {
      trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
      Watch watch(model, 0);
      const double end = (turns + beyond) * pi / 2;
      trajectory.advance(end, watch);
      const double last = (std::sin(2 * end) - 2 * end * std::cos(2 * end)) / 8;
      const double turn = turns * pi / 8;
      const double before = (turns - 1) * pi / 8;
      const bool up = turns % 2 == 1;
      EXPECT_NEAR(watch.range.maximum, up ? turn : std::max(before, last), 1e-13 * turn) << end;
      EXPECT_NEAR(watch.range.minimum, up ? -std::max(before, -last) : -turn, 1e-13 * turn) << end;
    }
}

} // namespace exact_outputs_tests
} // namespace vibroimpact::motion
