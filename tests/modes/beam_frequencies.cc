// Natural frequencies of beams against closed forms.
#include "modes/solve_beam.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <fstream>
#include <sstream>

namespace beam_frequencies_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

constexpr double two_pi = 2 * M_PI;

// Relative errors of the frequencies (beta L)^2 for a mesh of so many elements.
std::vector<double> errors(BeamDefinition beam, int elements, const std::vector<double> &exact,
                           int rigid) {
  beam.line.elements = elements;
  const int count = static_cast<int>(exact.size());
  const modes::NormalModes modes = solve_beam(beam, {rigid + count, {}});
  std::vector<double> error;
  for (int j = 0; j < count; ++j)
    error.push_back(std::sqrt(modes.eigenvalues[rigid + j]) /
                        (frequency_scale(beam) * exact[j] * exact[j]) -
                    1);
  return error;
}

// Relative error of a Hermite element of length h for the wave number b: (b h)^4 / 1440.
double hermite_error(double wave) { return std::pow(wave, 4) / 1440; }

void expect_fourth_order(const BeamDefinition &beam, const std::vector<double> &exact, int rigid) {
  const std::vector<double> coarse = errors(beam, 20, exact, rigid);
  const std::vector<double> fine = errors(beam, 40, exact, rigid);
  for (std::size_t j = 0; j < exact.size(); ++j) {
    EXPECT_GT(fine[j], 0) << "a Galerkin frequency lies above the exact one";
    EXPECT_NEAR(fine[j] / hermite_error(exact[j] / 40), 1, 0.02);
    EXPECT_NEAR(std::log2(coarse[j] / fine[j]), 4, 0.05) << j;
  }
}

/// What holds the free end of a cantilever: a mass with rotary inertia, and springs to the base.
struct Tip {
  double mass, inertia, spring, rotational_spring;
};

// Deflection A (cosh - cos) + B (sinh - sin) of beta x; at the tip
//   EI w'' + (k_r - omega^2 J) w' = 0,   -EI w''' + (k - omega^2 m) w = 0.
double tip_determinant(const BeamDefinition &beam, const Tip &tip, double omega) {
  const double stiffness = bending_stiffness(beam);
  const double b = std::sqrt(omega * std::sqrt(mass_per_length(beam) / stiffness));
  const double x = b * beam_length(beam);
  const double ch = std::cosh(x);
  const double sh = std::sinh(x);
  const double c = std::cos(x);
  const double s = std::sin(x);
  const double rotation = tip.rotational_spring - omega * omega * tip.inertia;
  const double translation = tip.spring - omega * omega * tip.mass;
  const double moment_a = stiffness * b * b * (ch + c) + rotation * b * (sh + s);
  const double moment_b = stiffness * b * b * (sh + s) + rotation * b * (ch - c);
  const double force_a = -stiffness * b * b * b * (sh - s) + translation * (ch - c);
  const double force_b = -stiffness * b * b * b * (ch + c) + translation * (sh - s);
  return (moment_a * force_b - moment_b * force_a) / (ch * ch);
}

void expect_tip_frequencies(const Tip &tip) {
  BeamDefinition beam = cantilever(80);
  beam.points[0].mass = tip.mass;
  beam.points[0].rotary_inertia = {0.5, tip.inertia, 0.5};
  beam.supports.push_back(
      {"spring", {"end", {}}, {}, {tip.spring, 0, 0, 0, tip.rotational_spring, 0}});
  const std::vector<double> exact =
      zeros([&](double omega) { return tip_determinant(beam, tip, omega); }, 1.0, 4);
  const modes::NormalModes modes = solve_beam(beam, {4, {}});
  for (int j = 0; j < 4; ++j)
    EXPECT_NEAR(std::sqrt(modes.eigenvalues[j]) / exact[j], 1, 1e-6) << j;
}

BeamDefinition double_cross() {
  std::ifstream file(VIBROIMPACT_SOURCE_DIR "/meshes/double-cross.msh");
  std::ostringstream content;
  content << file.rdbuf();
  BeamDefinition beam;
  beam.mesh_content = content.str();
  beam.section.width = beam.section.thickness = 0.125;
  beam.material = {200e9, 0.3, 8000};
  beam.supports.push_back({"plane", {"all", {}}, {false, false, true, true, true, false}, {}});
  beam.supports.push_back({"ends", {"ends", {}}, {true, true, false, false, false, false}, {}});
  return beam;
}

constexpr double arm_length = 5;

// The joint moves along an axis without turning. The dynamic stiffness of an arm with a pinned end
// is E A k cot k L along it and 2 EI b^3 / (tan b L - tanh b L) across it; over the eight arms both
// count equally, and their sum vanishes just below each clamped-pinned frequency.
double moving_joint(const BeamDefinition &beam, double clamped) {
  const double stiffness = bending_stiffness(beam);
  const double axial = 200e9 * 0.125 * 0.125;
  const auto sum = [&](double x) {
    const double b = x / arm_length;
    const double k = b * b * std::sqrt(stiffness / axial);
    return axial * k / std::tan(k * arm_length) * (std::tan(x) - std::tanh(x)) +
           2 * stiffness * b * b * b;
  };
  return bisect(sum, clamped - 0.3, clamped);
}

} // namespace

TEST(BeamFrequencies, ClampedFreeConvergesWithOrderFour) {
  BeamDefinition beam = thin_beam(1);
  hold_plane(beam);
  clamp_start(beam);
  expect_fourth_order(beam, clamped_free(4), 0);
}

TEST(BeamFrequencies, PinnedPinnedConvergesWithOrderFour) {
  BeamDefinition beam = thin_beam(1);
  hold_plane(beam);
  for (const char *end : {"start", "end"})
    beam.supports.push_back({end, {end, {}}, {true, true, true, false, false, false}, {}});
  expect_fourth_order(beam, {M_PI, 2 * M_PI, 3 * M_PI, 4 * M_PI}, 0);
}

TEST(BeamFrequencies, FreeFreeConvergesWithOrderFour) {
  BeamDefinition beam = thin_beam(1);
  hold_plane(beam);
  expect_fourth_order(beam, free_free(4), 2);
}

TEST(BeamFrequencies, TunedCantileverMatchesCaseS) {
  const std::vector<double> reference = {1.22641509082614, 4.023635362811373, 7.1291443348981405,
                                         10.253001347186117, 13.384917262213053};
  const double scale = frequency_scale(thin_beam(1));
  const modes::NormalModes coarse = solve_beam(tuned_cantilever(40), {3, {}});
  for (int j = 0; j < 3; ++j)
    EXPECT_NEAR(std::sqrt(coarse.eigenvalues[j]) / (scale * std::pow(reference[j], 2)), 1, 1e-6);
  const modes::NormalModes fine = solve_beam(tuned_cantilever(80), {5, {}});
  for (int j = 0; j < 5; ++j)
    EXPECT_NEAR(std::sqrt(fine.eigenvalues[j]) / (scale * std::pow(reference[j], 2)), 1, 1e-6);
  EXPECT_NEAR(std::sqrt(fine.eigenvalues[0]) / two_pi, 2.95, 1e-8);
}

TEST(BeamFrequencies, ElasticSupportAtTheFreeEnd) {
  expect_tip_frequencies({.mass = 0, .inertia = 0, .spring = 300, .rotational_spring = 2});
}

TEST(BeamFrequencies, LumpedRotaryInertiaAtTheFreeEnd) {
  expect_tip_frequencies({.mass = 0.05, .inertia = 2e-4, .spring = 0, .rotational_spring = 0});
}

TEST(BeamFrequencies, MassAndSpringsAtTheFreeEnd) {
  expect_tip_frequencies({.mass = 0.02, .inertia = 1e-4, .spring = 100, .rotational_spring = 1});
}

// Axial k: f = (2k - 1) / 4L sqrt(E / rho); torsional the same with G J / (rho I_p).
TEST(BeamFrequencies, AxialAndTorsionalWaves) {
  BeamDefinition beam = thin_beam(100);
  beam.section = {.kind = structure::SectionShape::Kind::circle, .diameter = 0.01};
  beam.supports.push_back({"line", {"all", {}}, {true, true, false, true, true, true}, {}});
  clamp_start(beam);
  const double axial = std::sqrt(206e9 / 7850) * M_PI / 2 / 0.3;
  const double shear = std::sqrt(206e9 / 2.6 / 7850) * M_PI / 2 / 0.3;
  EXPECT_NEAR(std::sqrt(solve_beam(beam, {1, {}}).eigenvalues[0]) / axial, 1, 2e-5);
  beam.supports[0].fixed = {true, true, true, true, true, false};
  EXPECT_NEAR(std::sqrt(solve_beam(beam, {1, {}}).eigenvalues[0]) / shear, 1, 2e-5);
}

TEST(BeamFrequencies, ARotatedBodyHasTheSameFrequencies) {
  BeamDefinition beam = thin_beam(20);
  beam.local_y = Vector3::UnitY();
  beam.points.push_back({"head", {"end", {}}, 0.05, {1e-4, 1e-4, 1e-4}});
  clamp_start(beam);
  const modes::NormalModes straight = solve_beam(beam, {10, {}});
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Vector3(1, -2, 3).normalized()).toRotationMatrix();
  beam.line.end = rotation * beam.line.end;
  beam.local_y = rotation * Vector3::UnitY();
  const modes::NormalModes rotated = solve_beam(beam, {10, {}});
  for (int j = 0; j < 10; ++j)
    EXPECT_NEAR(rotated.eigenvalues[j] / straight.eigenvalues[j], 1, 1e-11) << j;
}

// NAFEMS FV2. All arms turn together with the joint (pinned-pinned arms), or five times without it
// (clamped-pinned arms); in two more modes the joint moves, a little lower as the arms also
// stretch.
TEST(BeamFrequencies, PinEndedDoubleCross) {
  const BeamDefinition beam = double_cross();
  const modes::NormalModes modes = solve_beam(beam, {16, {}});
  const double scale =
      std::sqrt(bending_stiffness(beam) / mass_per_length(beam)) / (arm_length * arm_length);
  const std::vector<double> published = {11.336, 17.709, 45.345, 57.390};
  for (int round = 0; round < 2; ++round) {
    const double held = clamped_pinned(2)[round];
    const double moving = moving_joint(beam, held);
    const double turning = (round + 1) * M_PI;
    EXPECT_NEAR(scale * turning * turning / two_pi, published[2 * round], 6e-4);
    EXPECT_NEAR(scale * held * held / two_pi, published[2 * round + 1], 6e-4);
    const std::vector<double> exact = {turning, moving, moving, held, held, held, held, held};
    for (int j = 0; j < 8; ++j) {
      const double omega = std::sqrt(modes.eigenvalues[8 * round + j]);
      EXPECT_NEAR(omega / (scale * exact[j] * exact[j]), 1, 1.1 * hermite_error(exact[j] / 20));
    }
  }
}

} // namespace beam_frequencies_tests
