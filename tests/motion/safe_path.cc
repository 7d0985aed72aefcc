// Linear phases that eigenvectors cannot describe: they are dense blocks, and give the closed form.
// The closed forms are those of support/true_motion.h, with terms t exp(e t).
#include "motion/path/trajectory.h"
#include "motion/phase/exact_phases.h"
#include "support/lumped_models.h"
#include "support/true_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {
namespace safe_path_tests {

using namespace model;
using contact::ContactSet;
using testing::single_mass;
using testing::TrueForce;
using testing::TrueMode;
using testing::TrueMotion;

class Nobody : public Observer {};

Model forced(double stiffness, double damping, std::shared_ptr<const TimeFunction> force) {
  Model model({single_mass("block", 1, stiffness, damping)});
  if (force)
    model.add_force("force", std::move(force), {.body = 0, .point = 0}, Vector3::UnitX());
  return model;
}

bool has_eigenvectors(const Model &model) {
  const ContactSet none;
  const ModalForm form(LinearSystem(Equations(model, none)).matrix());
  return std::none_of(form.blocks().begin(), form.blocks().end(),
                      [](const ModalBlock &block) { return block.kind == BlockKind::dense; });
}

// True when the response to the excitation is separate from the modes.
bool responds(const Model &model) {
  const ContactSet none;
  const Equations equations(model, none);
  ExactPhases phases(equations, Settings{});
  return phases.take_sources(0) && !phases.present()->phase().has_dense();
}

struct End {
  double displacement = 0, velocity = 0, energy_residual = 0;
};

End integrated(const Model &model, double q, double v, double time, bool observed) {
  const ContactSet none;
  Trajectory trajectory(model, none, {});
  Nobody nobody;
  trajectory.start(0, Vector::Constant(1, q), Vector::Constant(1, v));
  if (observed)
    trajectory.advance(time, nobody);
  else
    trajectory.advance(time);
  return {trajectory.state()[0], trajectory.state()[1],
          observed ? trajectory.accuracy().energy_residual : 0};
}

void expect_closed_form(const TrueMode &mode, const TrueForce &force, double q, double v,
                        double time) {
  const Model model =
      forced(mode.stiffness, mode.damping,
             force.amplitude != 0 ? std::make_shared<Harmonic>(Given::displacement, force.amplitude,
                                                               force.frequency, force.phase)
                                  : nullptr);
  const TrueMotion<long double> truth({mode}, force, force.phase, {q}, {v});
  const auto expected = truth.at(time);
  const auto size = static_cast<double>(truth.size(time));
  for (const bool observed : {true, false}) {
    const End end = integrated(model, q, v, time, observed);
    EXPECT_NEAR(end.displacement, static_cast<double>(expected[0]), 1e-12 * size);
    EXPECT_LT(end.energy_residual, 1e-10);
  }
}

constexpr double omega = 20.5; // its square is exact

TEST(SafePathTest, CriticalDamping) {
  const TrueMode mode{.stiffness = omega * omega, .damping = 2 * omega, .load = 1, .weight = 1};
  EXPECT_FALSE(has_eigenvectors(forced(mode.stiffness, mode.damping, nullptr)));
  expect_closed_form(mode, {}, 0.01, -0.3, 0.7);
  expect_closed_form(mode, {.amplitude = 5, .frequency = 31, .phase = 0.4}, 0.01, -0.3, 0.7);
}

// Of some of these systems Eigen returns two equal eigenvalues as a pair, with vectors that are
// none.
TEST(SafePathTest, CriticallyDampedBesideAnUndamped) {
  const ContactSet none;
  for (int i = 4; i < 800; ++i) {
    const double w = i / 8.0;
    const TrueMode critical{.stiffness = w * w, .damping = 2 * w, .load = 1, .weight = 1};
    const TrueMode other{.stiffness = w * w * 1.17, .damping = 0, .load = 1, .weight = 1};
    const Model model({single_mass("critical", 1, critical.stiffness, critical.damping),
                       single_mass("other", 1, other.stiffness, other.damping)});
    EXPECT_FALSE(has_eigenvectors(model)) << w;
    Trajectory trajectory(model, none, {});
    trajectory.start(0, Vector::Constant(2, 0.02), Vector::Constant(2, -0.3 * w));
    trajectory.advance(3 / w);
    const long double time = 3 / w;
    const TrueMotion<long double> first({critical}, {}, 0, {0.02}, {-0.3 * w});
    const TrueMotion<long double> second({other}, {}, 0, {0.02}, {-0.3 * w});
    EXPECT_NEAR(trajectory.state()[0], static_cast<double>(first.at(time)[0]), 1e-14) << w;
    EXPECT_NEAR(trajectory.state()[1], static_cast<double>(second.at(time)[0]), 1e-14) << w;
  }
}

// Next to critical damping the eigenvectors are nearly the same; both ways must be right on their
// side of the limit.
TEST(SafePathTest, NearlyCriticalDamping) {
  for (const double detuning : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, -1e-12, -1e-9, -1e-6})
    expect_closed_form(
        {.stiffness = omega * omega, .damping = 2 * omega * (1 + detuning), .load = 1, .weight = 1},
        {}, 0.01, -0.3, 0.2);
  EXPECT_FALSE(has_eigenvectors(forced(omega * omega, 2 * omega * (1 + 1e-12), nullptr)));
  EXPECT_TRUE(has_eigenvectors(forced(omega * omega, 2 * omega * (1 + 1e-3), nullptr)));
}

TEST(SafePathTest, FreeMass) {
  const TrueMode mode{.stiffness = 0, .damping = 0, .load = 1, .weight = 1};
  EXPECT_FALSE(has_eigenvectors(forced(0, 0, nullptr)));
  expect_closed_form(mode, {}, 0.1, -0.2, 3);
  expect_closed_form(mode, {.amplitude = 3, .frequency = 7, .phase = -1}, 0.1, -0.2, 3);
}

TEST(SafePathTest, ForceAtTheNaturalFrequency) {
  const TrueMode mode{.stiffness = omega * omega, .damping = 0, .load = 1, .weight = 1};
  const TrueForce force{.amplitude = 5, .frequency = omega, .phase = 0.3};
  const auto harmonic = std::make_shared<Harmonic>(Given::displacement, force.amplitude,
                                                   force.frequency, force.phase);
  EXPECT_TRUE(has_eigenvectors(forced(mode.stiffness, 0, harmonic)));
  EXPECT_FALSE(responds(forced(mode.stiffness, 0, harmonic)));
  EXPECT_TRUE(responds(forced(
      mode.stiffness, 0, std::make_shared<Harmonic>(Given::displacement, 5, 1.01 * omega, 0.3))));
  expect_closed_form(mode, force, 0, 0, 2);
  expect_closed_form(mode, force, 0.02, 0.5, 2);
}

// Re(a exp(e t)), e an eigenvalue of the damped oscillator: q = Re(a t exp(e t) / (2 e + d)).
class AtEigenvalue : public TimeFunction {
public:
  explicit AtEigenvalue(std::complex<double> exponent) : e_(exponent) {}
  double value(double time) const override { return std::exp(e_ * time).real(); }
  double rate(double time) const override { return (e_ * std::exp(e_ * time)).real(); }
  double acceleration(double time) const override { return (e_ * e_ * std::exp(e_ * time)).real(); }
  double period() const override { return 0; }
  double highest_frequency() const override { return std::abs(e_); }
  std::shared_ptr<const TimeFunction> with_frequency(double /*frequency*/) const override {
    return nullptr;
  }
  std::optional<ExponentialForm> exponential_form(double time) const override {
    return ExponentialForm{.origin = time,
                           .terms = {{.amplitude = std::exp(e_ * time), .exponent = e_}},
                           .polynomial = {}};
  }

private:
  std::complex<double> e_;
};

TEST(SafePathTest, DecayingForceAtAnEigenvalue) {
  const double d = 6;
  const std::complex<double> e(-3, std::sqrt(omega * omega - 9));
  const auto force = std::make_shared<AtEigenvalue>(e);
  const Model model = forced(omega * omega, d, force);
  EXPECT_FALSE(responds(model));
  const double time = 0.9;
  const std::complex<double> c = 1.0 / (2.0 * e + d);
  // From q = 0 and q' = Re c.
  const End end = integrated(model, 0, c.real(), time, true);
  EXPECT_NEAR(end.displacement, (c * time * std::exp(e * time)).real(), 1e-12 * std::abs(c));
  EXPECT_LT(end.energy_residual, 1e-10);
}

} // namespace safe_path_tests
} // namespace vibroimpact::motion
