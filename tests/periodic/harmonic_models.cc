// Harmonic balance of models with contacts: averaging with one harmonic, the exact motion with
// many, and what it refuses.
#include "periodic/harmonic_model.h"

#include "common/error.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "continuation/branch.h"
#include "continuation/harmonic_series.h"
#include "forced_models.h"
#include "model/histories.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::periodic {
namespace harmonic_models_tests {

using continuation::HarmonicBalance;
using std::numbers::pi;
using testing::ForcedMap;
using testing::Oscillator;
using testing::oscillator;

/// An oscillator by its angular frequency.
class ByFrequency : public continuation::HarmonicSystem {
public:
  ByFrequency(Oscillator oscillator, Index harmonics)
      : oscillator_{std::move(oscillator)},
        harmonics_{harmonics}, grids_{harmonics, default_intervals(harmonics)} {
    check_harmonic(oscillator_.model, oscillator_.contacts, 0, harmonics);
  }
  continuation::HarmonicEquations equations(double key) override {
    oscillator_.model.set_frequency(0, key);
    model_.emplace(oscillator_.model, oscillator_.contacts, 0, grids_, harmonics_);
    return model_->equations();
  }
  continuation::ForceSeries force(Index element, const RowVector &y, bool slopes) override {
    return model_->force(element, y, slopes);
  }
  const HarmonicModel &model() const { return *model_; }

private:
  Oscillator oscillator_;
  Index harmonics_;
  HarmonicGrids grids_;
  std::optional<HarmonicModel> model_;
};

Vector at(double key) { return Vector::Constant(1, key); }

std::vector<double> folds(double mu, Index harmonics) {
  ByFrequency system(testing::isolator(0.6, mu), harmonics);
  HarmonicBalance problem(system, harmonics, Vector::Ones(2), 1.4);
  continuation::Settings settings;
  settings.first_key = {.lower = 0.5, .upper = 2};
  settings.longest_step = 0.05;
  const auto start =
      continuation::solve(problem, {problem.linear_response(0.6), at(0.6)}, settings);
  const auto branch = continuation::follow(problem, {start.point, {}, true}, settings);
  EXPECT_EQ(branch.end, continuation::End::upper_bound) << branch.reason;
  std::vector<double> found;
  for (const auto &special : branch.special)
    if (special.kind == continuation::Special::fold)
      found.push_back(special.at.point.keys(0));
  std::sort(found.begin(), found.end());
  return found;
}

TEST(HarmonicModelsTest, OneHarmonicIsFirstOrderAveraging) {
  EXPECT_TRUE(folds(0.5, 1).empty());
  const std::vector<std::pair<double, std::vector<double>>> rows = {
      {1, {1.226135, 1.244841}}, {2, {1.231127, 1.371611}}, {5, {1.232408, 1.681482}}};
  for (const auto &[mu, expected] : rows) {
    const std::vector<double> found = folds(mu, 1);
    ASSERT_EQ(found.size(), 2u) << mu;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(found[i], expected[i], 6e-7) << mu;
  }
}

// The dashpot's force jumps, so that the folds converge like H^-3, with a beat between the instants
// at which the stop is reached and left.
TEST(HarmonicModelsTest, ManyHarmonicsAreTheExactMotion) {
  const std::vector<double> exact = {1.23127927195557, 1.36274825262772};
  std::vector<double> before(2, 1);
  for (const Index harmonics : {5, 15}) {
    const std::vector<double> found = folds(2, harmonics);
    ASSERT_EQ(found.size(), 2u) << harmonics;
    for (std::size_t i = 0; i < 2; ++i) {
      const double error = std::abs(found[i] - exact[i]);
      EXPECT_LT(error, before[i] / 9) << harmonics << " " << i;
      before[i] = error;
    }
  }
  EXPECT_LT(before[1], 2e-5);
}

/// Displacement and rate at phase 0 of an oscillator, and what is left out of both, summed up.
struct AtPhaseZero {
  double displacement = 0, rate = 0, missing = 0, missing_rate = 0, force = 0;
};

AtPhaseZero balanced(const Oscillator &oscillator, double omega, Index harmonics) {
  ByFrequency system(oscillator, harmonics);
  const auto m =
      static_cast<Index>(oscillator.contacts.size() + oscillator.model.connections().size());
  HarmonicBalance problem(system, harmonics, Vector::Ones(m), 1);
  const auto found = continuation::solve(problem, {problem.linear_response(omega), at(omega)}, {});
  const auto motion = problem.motion(found.point.state, omega);
  const Vector basis = continuation::harmonic_basis(0, harmonics);
  const RowVector left = problem.left_out(motion, omega).coordinates.row(0);
  const Vector amplitudes = continuation::harmonic_amplitudes(left);
  const auto most = static_cast<double>(amplitudes.size() - 1);
  return {.displacement = (motion.coordinates * basis)(0),
          .rate = omega * (motion.coordinates * continuation::harmonic_rate(harmonics) * basis)(0),
          .missing = amplitudes.sum(),
          .missing_rate = omega * amplitudes.dot(Vector::LinSpaced(amplitudes.size(), 0, most)),
          .force = motion.forces.front().largest};
}

// Beside the motion of a shooting method the error is no larger than twice what is left out, the
// harmonics above 3 H included, and that falls like H^-order.
void expect_exact(const Oscillator &shot, double omega, Index harmonics, double order) {
  ForcedMap forced(shot, false);
  Vector state = Vector::Zero(forced.map.size());
  state.tail(forced.map.size() - 2) = shot.contacts.initial_internal();
  for (int period = 0; period < 60; ++period)
    state = forced.map.carry(0, 1, state);
  const Orbit orbit = find_orbit(forced.map, 1, state);
  const Vector zero = forced.map.carry(orbit.section.phase, 1, orbit.point.state);
  const AtPhaseZero few = balanced(shot, omega, harmonics / 3);
  const AtPhaseZero many = balanced(shot, omega, harmonics);
  EXPECT_GT(many.force, 0.01);
  EXPECT_NEAR(many.displacement, zero(0), 2 * many.missing + 1e-11);
  EXPECT_NEAR(many.rate, zero(1), 2 * many.missing_rate + 1e-10);
  EXPECT_LT(many.missing, few.missing * std::pow(3, 0.5 - order));
}

TEST(HarmonicModelsTest, ElasticStop) {
  Oscillator model = oscillator(1, 40, 0.8);
  model.push(3, 5, 0.4);
  model.stop({{0.1, std::make_shared<contact::LinearPenalty>(30)}});
  expect_exact(model, 5, 39, 3); // a kink
}

// A moving base carries the block and the stop, a second source has three times the frequency, and
// a constant one pulls.
TEST(HarmonicModelsTest, MovingBaseConstantLoadAndHigherHarmonic) {
  Oscillator model = oscillator(1, 40, 0.8);
  model.model.add_base_motion(
      "floor", std::make_shared<model::Harmonic>(model::Given::acceleration, 3, 5, 0.3), {0},
      Vector3::UnitX());
  model.push(1, 15, 0.7);
  model.model.add_force("weight", model::make_constant(model::Given::displacement, 1.5), {},
                        Vector3::UnitX());
  model.stop({{0.1, std::make_shared<contact::BilinearStop>(30, 0.5)}});
  ForcedMap forced(model, false);
  expect_exact(model, 5, 39, 2); // a jump
}

TEST(HarmonicModelsTest, KelvinVoigtBumper) {
  Oscillator model = oscillator(1, 40, 0.8);
  model.push(3, 5, 0.4);
  model.stop({{0.1, std::make_shared<contact::KelvinVoigtBumper>(30, 12)}});
  expect_exact(model, 5, 39, 2); // a jump
}

TEST(HarmonicModelsTest, CubicSpring) {
  Oscillator model = oscillator(1, 40, 0.8);
  model.push(3, 5, 0.4);
  model.model.add_connection({.name = "spring",
                              .side_a = "block.head",
                              .side_b = "ground",
                              .elongation = model.model.displacement({}, -Vector3::UnitX(), true),
                              .stiffness = 5,
                              .cubic_stiffness = 400});
  expect_exact(model, 5, 15, 10); // smooth
}

std::string message(const Oscillator &refused, Index harmonics = 3) {
  try {
    check_harmonic(refused.model, refused.contacts, 0, harmonics);
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

TEST(HarmonicModelsTest, Refusals) {
  Oscillator model = oscillator(1, 40, 0.8);
  model.push(3, 5);
  EXPECT_NE(message(model).find("no contact and no cubic spring"), std::string::npos);
  const auto stop = std::make_shared<contact::LinearPenalty>(30);
  model.stop({{0.1, stop}});
  EXPECT_EQ(message(model), "");
  model.push(1, 20);
  EXPECT_NE(message(model).find("push1 is not made of the first 3 harmonics"), std::string::npos);
  EXPECT_EQ(message(model, 4), "");
  model.push(1, 7);
  EXPECT_NE(message(model, 9).find("push2"), std::string::npos);

  Oscillator rigid = oscillator(1, 40, 0.8);
  rigid.push(3, 5);
  rigid.stop({{0.1, testing::newton(0.8)}});
  EXPECT_NE(message(rigid).find("is rigid (Law = newton restitution)"), std::string::npos)
      << message(rigid);

  Oscillator loose = oscillator(1, 0, 0.8);
  loose.push(3, 5);
  loose.stop({{0.1, stop}});
  EXPECT_NE(message(loose).find("no spring or support holds them"), std::string::npos);
}

} // namespace harmonic_models_tests
} // namespace vibroimpact::periodic
