// Nonlinear modes at phase resonance: damping ratios of linear systems, dashpots and restitution in
// closed form, and peaks of forced motions beside the backbone.
#include "analyses/modes/known_modes.h"

#include "analyses/curves/orbit_branch.h"

#include <algorithm>

namespace vibroimpact::analyses {
namespace phase_resonance_tests {

using namespace known_modes;
using testing::field_of;

// The self-excitation of a damped linear mode is its damping: xi = 2 zeta omega_0, at omega_0.
TEST(PhaseResonance, DampingOfALinearModeIsBalanced) {
  NonlinearMode::Settings settings = between(0.1, 5);
  settings.losses = periodic::Losses::balanced;
  const double damping = 0.06;
  const PointResult result = mode_of(oscillator(damping), settings);
  for (const double omega : Backbone(result).omega)
    EXPECT_NEAR(omega, 1, 1e-12);
  for (const double ratio : field_of(result, "damping_ratio").values)
    EXPECT_NEAR(ratio, damping / 2, 1e-12);
}

// On a rigid stop that touches at rest: x'' - xi x' + x = 0 for half a turn, in which the velocity
// grows by 1 / e.
TEST(PhaseResonance, RestitutionIsBalanced) {
  for (const double restitution : {0.9, 0.6}) {
    NonlinearMode::Settings settings = between(0.1, 5);
    settings.losses = periodic::Losses::balanced;
    const PointResult result =
        mode_of(oscillator_on_stop(0, testing::newton(restitution)), settings);
    const double decrement = -std::log(restitution) / pi;
    for (const double omega : Backbone(result).omega)
      EXPECT_NEAR(omega, 2 / std::sqrt(1 + decrement * decrement), 1e-11);
    for (const double excitation : field_of(result, "self_excitation").values)
      EXPECT_NEAR(excitation, 2 * decrement / std::sqrt(1 + decrement * decrement), 1e-11);
  }
}

// The dashpot of a single mass is balanced at every instant, so that it moves as one without.
TEST(PhaseResonance, DashpotOfASingleMassIsBalancedAtEveryInstant) {
  NonlinearMode::Settings settings = between(0.1, 5);
  settings.losses = periodic::Losses::balanced;
  const double damping = 0.06;
  const PointResult result = mode_of(oscillator_on_stop(1, testing::newton(1), damping), settings);
  const Backbone backbone(result);
  EXPECT_DOUBLE_EQ(backbone.energy.back(), 5);
  for (std::size_t i = 0; i < backbone.energy.size(); ++i) {
    const double amplitude = std::sqrt(2 * backbone.energy[i]);
    const double period = amplitude <= 1 ? 2 * pi : 2 * (pi - std::acos(1 / amplitude));
    EXPECT_NEAR(2 * pi / backbone.omega[i], period, 1e-10) << backbone.energy[i];
    EXPECT_NEAR(field_of(result, "self_excitation").values[i], damping, 1e-11);
  }
}

// The largest displacement along a forced branch, and its frequency: by the parabola through three
// points.
struct Peak {
  double displacement = 0, omega = 0;
};
Peak forced_peak(double ratio) {
  model::Model model({testing::single_mass("block", 1, 1, 2 * ratio)});
  model.add_force("push",
                  std::make_shared<model::Harmonic>(model::Given::displacement, 2 * ratio, 1.2, 0),
                  {}, Vector3::UnitX());
  System system = with_cubic_spring(testing::system_of(std::move(model)), 0.5);
  OrbitBranch::Settings settings{
      .parameter = {.path = {}, .values = {0.8 / (2 * pi), 1.4 / (2 * pi)}},
      .start = {.state = {0, 0}},
      .excitation = {}};
  settings.continuation.first_key = {.lower = settings.parameter.values[0],
                                     .upper = settings.parameter.values[1]};
  settings.continuation.longest_step = 0.05;
  ModePoint point;
  OrbitBranch(settings).run_line(0, system, point);
  EXPECT_EQ(point.result.status, Status::finished) << point.result.reason;
  const std::vector<double> &size =
      field_of(point.result, "point/block.head/displacement_x/largest").values;
  const std::vector<double> &frequency = field_of(point.result, "frequency").values;
  const std::vector<double> &along = field_of(point.result, "arclength").values;
  const auto top =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  Matrix powers(3, 3);
  Vector sizes(3), frequencies(3);
  for (Index i = 0; i < 3; ++i) {
    const std::size_t at = top - 1 + static_cast<std::size_t>(i);
    const double s = along[at] - along[top];
    powers.row(i) << 1, s, s * s;
    sizes[i] = size[at];
    frequencies[i] = frequency[at];
  }
  const Vector a = powers.inverse() * sizes, b = powers.inverse() * frequencies;
  const double s = -a[1] / (2 * a[2]);
  return {a[0] + a[1] * s + a[2] * s * s, 2 * pi * (b[0] + b[1] * s + b[2] * s * s)};
}

// Peaks of forced motions leave the backbone by the square of the damping ratio.
TEST(PhaseResonance, ForcedPeaksLieOnTheBackbone) {
  std::vector<double> off;
  for (const double ratio : {0.08, 0.04}) {
    const Peak peak = forced_peak(ratio);
    off.push_back(peak.omega -
                  backbone_of_cubic_spring(0.5, peak.displacement * peak.displacement));
  }
  EXPECT_LT(std::abs(off[1]), 2 * 0.04 * 0.04);
  EXPECT_NEAR(off[0] / off[1], 4, 0.4);
}

} // namespace phase_resonance_tests
} // namespace vibroimpact::analyses
