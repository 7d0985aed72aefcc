// Natural frequencies of thick, tapered, hinged and prestressed beams, and of masses beside the
// axis, against closed forms and published values.
#include "modes/solve_beam.h"

#include "common/decompositions.h"
#include "structure/beam_properties.h"

#include <gtest/gtest.h>

namespace beam_theories_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

using structure::BeamTheory;
using structure::Member;
using structure::SectionShape;

constexpr double two_pi = 2 * M_PI;

/// One plane of bending of a uniform beam under an axial force.
struct Wave {
  double stiffness, shear_flexibility, mass, rotary_inertia, length, axial_force = 0;
};

// v' = r + f V, r' = M / EI, M' = -V - rho I omega^2 r, Q' = -rho A omega^2 v, with the force
// across the undeformed axis Q = V + N v': the state (v, r, M / EI, Q / EI) of the far end from
// that of the near one. Forces are divided by EI, as the exponential needs numbers of one
// magnitude.
Eigen::Matrix4d transfer(const Wave &wave, double omega) {
  const double square = omega * omega / wave.stiffness;
  const double force = wave.axial_force / wave.stiffness;
  const double flexibility = wave.shear_flexibility * wave.stiffness;
  const double soft = 1 / (1 + force * flexibility);
  Eigen::Matrix4d rate = Eigen::Matrix4d::Zero();
  rate(0, 1) = soft;
  rate(0, 3) = soft * flexibility;
  rate(1, 2) = 1;
  rate(2, 1) = force * rate(0, 1) - square * wave.rotary_inertia;
  rate(2, 3) = force * rate(0, 3) - 1;
  rate(3, 0) = -square * wave.mass;
  return exponential(rate * wave.length);
}

/// What is zero at an end: positions in the state.
using End = std::array<int, 2>;
constexpr End clamped{0, 1}, pinned{0, 2}, free_end{2, 3};

/// Angular frequencies of the first elastic modes.
std::vector<double> exact(const Wave &wave, const End &near, const End &far, int count) {
  std::vector<int> unknown;
  for (int i = 0; i < 4; ++i)
    if (i != near[0] && i != near[1])
      unknown.push_back(i);
  const auto determinant = [&](double omega) {
    return transfer(wave, omega)(far, unknown).determinant();
  };
  const double step = 0.1 * std::sqrt(wave.stiffness / wave.mass) / (wave.length * wave.length);
  return zeros(determinant, step, count);
}

/// 1 m long, 0.2 m deep, bending along x.
BeamDefinition thick_beam(BeamTheory theory) {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(0, 0, 1), 1};
  beam.section = {.width = 0.1, .thickness = 0.2, .theory = theory};
  beam.material = {2e11, 0.3, 8000};
  beam.plane_normal = 1;
  beam.supports.push_back({"line", {"all", {}}, {false, false, true, false, false, false}, {}});
  return beam;
}

Wave wave_of(const BeamDefinition &beam, double length = 1, double axial_force = 0) {
  const auto p = structure::beam_properties(beam.section, beam.material);
  return {p.bending_stiffness_y,
          p.shear_flexibility_z,
          p.mass_per_length,
          p.rotary_inertia_y,
          length,
          axial_force};
}

void hold(BeamDefinition &beam, const std::string &end, const End &how) {
  if (how == clamped)
    beam.supports.push_back({end, {end, {}}, {true, true, true, true, true, true}, {}});
  if (how == pinned)
    beam.supports.push_back({end, {end, {}}, {true, true, true, false, false, false}, {}});
}

std::vector<double> omegas(BeamDefinition beam, int elements, int count) {
  beam.line.elements = elements;
  const modes::NormalModes modes = solve_beam(beam, {count, {}});
  std::vector<double> found;
  for (int j = 0; j < count; ++j)
    found.push_back(std::sqrt(std::max(modes.eigenvalues[j], 0.0)));
  return found;
}

/// `rigid` modes come before the exact ones. The errors fall with the order 4 and are small.
void expect_fourth_order(const BeamDefinition &beam, const std::vector<double> &exact, int rigid) {
  const int count = static_cast<int>(exact.size());
  const std::vector<double> coarse = omegas(beam, 32, rigid + count);
  const std::vector<double> fine = omegas(beam, 64, rigid + count);
  for (int j = 0; j < count; ++j) {
    const double error = fine[rigid + j] / exact[j] - 1;
    const double coarse_error = coarse[rigid + j] / exact[j] - 1;
    EXPECT_NEAR(std::log2(coarse_error / error), 4, 0.1)
        << j << ": " << coarse_error << " " << error;
    EXPECT_LT(std::abs(error), 1e-6 * std::pow(j + 1, 4)) << j;
  }
}

void expect_timoshenko(const End &near, const End &far, int rigid) {
  BeamDefinition beam = thick_beam(BeamTheory::timoshenko);
  hold(beam, "start", near);
  hold(beam, "end", far);
  expect_fourth_order(beam, exact(wave_of(beam), near, far, 3), rigid);
}

Member part(const BeamDefinition &beam, const std::string &name, double from, double to) {
  return {
      .name = name, .between = {{from, to}}, .section = beam.section, .material = beam.material};
}

} // namespace

TEST(BeamTheories, ExactFrequenciesContainTheKnownOnes) {
  const Wave slender{1, 0, 1, 0, 1};
  const std::vector<double> known = clamped_free(3);
  const std::vector<double> found = exact(slender, clamped, free_end, 3);
  for (int j = 0; j < 3; ++j)
    EXPECT_NEAR(found[j] / (known[j] * known[j]), 1, 1e-9);
}

TEST(BeamTheories, TimoshenkoPinnedPinned) { expect_timoshenko(pinned, pinned, 0); }
TEST(BeamTheories, TimoshenkoClampedFree) { expect_timoshenko(clamped, free_end, 0); }
TEST(BeamTheories, TimoshenkoClampedClamped) { expect_timoshenko(clamped, clamped, 0); }
TEST(BeamTheories, TimoshenkoFreeFree) { expect_timoshenko(free_end, free_end, 2); }

// Without locking a slender beam has the frequencies of the other theory, however few its elements.
TEST(BeamTheories, SlenderBeamsAreAlikeInBothTheories) {
  BeamDefinition beam = cantilever(8);
  const std::vector<double> slender = omegas(beam, 8, 3);
  beam.section.theory = BeamTheory::timoshenko;
  const std::vector<double> thick = omegas(beam, 8, 3);
  for (int j = 0; j < 3; ++j)
    EXPECT_NEAR(thick[j] / slender[j], 1, 2e-4);
}

// NAFEMS FV5 [nafems1987]: 10 m long, 2 m square; bending (twice each), torsion, stretch.
TEST(BeamTheories, DeepSimplySupportedBeam) {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(10, 0, 0), 60};
  beam.section = {.width = 2, .thickness = 2, .theory = BeamTheory::timoshenko};
  beam.material = {200e9, 0.3, 8000};
  beam.supports = {{"A", {"start", {}}, {true, true, true, true, false, false}, {}},
                   {"B", {"end", {}}, {false, true, true, false, false, false}, {}}};
  const std::vector<double> published = {42.650, 42.650, 71.20,  125.00, 148.15,
                                         148.15, 213.61, 283.47, 283.47};
  const std::vector<double> found = omegas(beam, 60, 9);
  for (int j = 0; j < 9; ++j)
    EXPECT_NEAR(found[j] / two_pi / published[j], 1, 4e-4) << j;
}

// VPCS SDLL09 (code_aster V2.02.009, after Mabie and Rogers 1972): a wedge four times as thick and
// four or five times as wide at the clamp as at the tip. f = lambda h_1 / (2 pi L^2) sqrt(E / 12
// rho).
TEST(BeamTheories, TaperedCantilevers) {
  const std::vector<std::vector<double>> published = {{23.289, 73.9, 165.23, 299.7, 478.1},
                                                      {24.308, 75.56, 167.21, 301.9, 480.4}};
  for (int ratio : {4, 5}) {
    BeamDefinition beam = thick_beam(BeamTheory::euler_bernoulli);
    beam.section = {
        .width = 0.01 * ratio, .thickness = 0.04, .end_width = 0.01, .end_thickness = 0.01};
    hold(beam, "start", clamped);
    const std::vector<double> found = omegas(beam, 40, 5);
    const double scale = 0.01 * std::sqrt(2e11 / 12 / 8000);
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(found[j] / scale / published[ratio - 4][j], 1, j == 1 ? 7e-4 : 4e-4) << j;
  }
}

// NAFEMS FV4 [nafems1987]: masses of 10 t and 1 t, 2 m to either side of the end of a shaft.
TEST(BeamTheories, CantileverWithMassesBesideItsAxis) {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(10, 0, 0), 20};
  beam.section = {.kind = SectionShape::Kind::circle, .diameter = 0.5};
  beam.material = {200e9, 0.3, 8000};
  clamp_start(beam);
  beam.points = {{.name = "heavy", .at = {"end", {}}, .mass = 10000, .offset = Vector3(0, 2, 0)},
                 {.name = "light", .at = {"end", {}}, .mass = 1000, .offset = Vector3(0, -2, 0)}};
  const std::vector<double> published = {1.723, 1.727, 7.413, 9.972, 18.155, 26.957};
  const std::vector<double> slender = omegas(beam, 20, 6);
  beam.section.theory = BeamTheory::timoshenko;
  const std::vector<double> thick = omegas(beam, 20, 6);
  // Where shear and rotary inertia count, in the last three, the published values lie between those
  // of the two theories.
  for (int j = 0; j < 3; ++j)
    EXPECT_NEAR(slender[j] / two_pi, published[j], 6e-4) << j;
  for (int j = 3; j < 6; ++j) {
    EXPECT_LT(published[j], slender[j] / two_pi) << j;
    EXPECT_GT(published[j], thick[j] / two_pi) << j;
  }
}

// Clamped at both ends, a hinge in the middle: no force there in symmetric modes, which are those
// of two clamped-free beams; no deflection in the others, clamped-pinned ones.
TEST(BeamTheories, HingeInTheMiddle) {
  for (const BeamTheory theory : {BeamTheory::euler_bernoulli, BeamTheory::timoshenko}) {
    BeamDefinition beam = thick_beam(theory);
    hold(beam, "start", clamped);
    hold(beam, "end", clamped);
    beam.members = {part(beam, "root", 0, 0.5)};
    beam.hinges = {{"joint", "root", {"", Vector3(0, 0, 0.5)}, {}}};
    beam.hinges[0].free[4] = true; // about local y, which is global y
    const Wave half = wave_of(beam, 0.5);
    std::vector<double> expected = exact(half, clamped, free_end, 2);
    for (const double omega : exact(half, clamped, pinned, 2))
      expected.push_back(omega);
    std::sort(expected.begin(), expected.end());
    expected.resize(3);
    if (theory == BeamTheory::euler_bernoulli) {
      expect_fourth_order(beam, expected, 0);
    } else { // the element beside the hinge adds an error of the order 3
      const std::vector<double> found = omegas(beam, 64, 3);
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(found[j] / expected[j], 1, 1e-6 * std::pow(j + 1, 2)) << j;
    }
  }
}

// omega^2 = (EI b^4 + N b^2) / rho A, b = n pi / L.
TEST(BeamTheories, PinnedBeamUnderAnAxialForce) {
  BeamDefinition beam = thick_beam(BeamTheory::euler_bernoulli);
  hold(beam, "start", pinned);
  hold(beam, "end", pinned);
  beam.members = {part(beam, "all", 0, 1)};
  const Wave wave = wave_of(beam);
  const double buckling = M_PI * M_PI * wave.stiffness;
  for (const double share : {-0.999, -0.5, 3.0}) {
    beam.members[0].axial_force = share * buckling;
    std::vector<double> expected;
    for (const int n : {1, 2, 3})
      expected.push_back(
          std::sqrt(wave.stiffness / wave.mass *
                    (std::pow(n * M_PI, 4) + share * M_PI * M_PI * std::pow(n * M_PI, 2))));
    const std::vector<double> found = omegas(beam, 40, 3);
    for (int n = 1; n <= 3;
         ++n) // error of the bending stiffness, against what the force leaves of it
      EXPECT_NEAR(found[n - 1] / expected[n - 1], 1,
                  1.2 * std::pow(n * M_PI / 40, 4) / 1440 / (1 + share / (n * n)));
  }
}

// A wire: omega = n pi / L sqrt(N / rho A), raised by its bending stiffness.
TEST(BeamTheories, StretchedWire) {
  BeamDefinition beam = thick_beam(BeamTheory::euler_bernoulli);
  beam.section.width = beam.section.thickness = 1e-3;
  hold(beam, "start", pinned);
  hold(beam, "end", pinned);
  beam.members = {part(beam, "all", 0, 1)};
  beam.members[0].axial_force = 500;
  const std::vector<double> found = omegas(beam, 40, 3);
  for (int n = 1; n <= 3; ++n)
    EXPECT_NEAR(found[n - 1] / (n * M_PI * std::sqrt(500 / (8000 * 1e-6))), 1, 2e-3);
}

// Clamped-free and clamped-clamped, thick, in tension and compression.
TEST(BeamTheories, PrestressedThickBeams) {
  for (const End &far : {free_end, clamped, pinned})
    for (const double share : {-0.2, 1.0}) {
      BeamDefinition beam = thick_beam(BeamTheory::timoshenko);
      hold(beam, "start", clamped);
      hold(beam, "end", far);
      beam.members = {part(beam, "all", 0, 1)};
      const double force = share * M_PI * M_PI * wave_of(beam).stiffness;
      beam.members[0].axial_force = force;
      const Wave wave = wave_of(beam, 1, force);
      const std::vector<double> expected = exact(wave, clamped, far, 3);
      const std::vector<double> found = omegas(beam, 64, 3);
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(found[j] / expected[j], 1, 2e-4 * (j + 1)) << j;
    }
}

// Engesser: P = P_e / (1 + P_e / kappa G A). Below it the square of the first frequency falls
// linearly with the force. The load converges with the order 2.
TEST(BeamTheories, BucklingLoadOfAThickColumn) {
  BeamDefinition beam = thick_beam(BeamTheory::timoshenko);
  hold(beam, "start", pinned);
  hold(beam, "end", pinned);
  const Wave wave = wave_of(beam);
  const double euler = M_PI * M_PI * wave.stiffness;
  const double expected = euler / (1 + euler * wave.shear_flexibility);
  beam.members = {part(beam, "all", 0, 1)};
  const auto error = [&](int elements) {
    std::array<double, 2> squares{};
    for (const int i : {0, 1}) {
      beam.members[0].axial_force = -(0.99 + 0.005 * i) * expected;
      squares[i] = std::pow(omegas(beam, elements, 1)[0], 2);
    }
    return 0.99 + 0.005 * squares[0] / (squares[0] - squares[1]) - 1;
  };
  EXPECT_LT(std::abs(error(64)), 1e-4);
  EXPECT_NEAR(std::log2(error(16) / error(32)), 2, 0.2);
}

// A twisted shaft in tension: G J is raised by N (I_y + I_z) / A.
TEST(BeamTheories, TensionStiffensTorsion) {
  BeamDefinition beam = thick_beam(BeamTheory::euler_bernoulli);
  beam.plane_normal.reset();
  beam.section = {.kind = SectionShape::Kind::tube, .diameter = 0.1, .wall_thickness = 0.001};
  beam.supports = {{"line", {"all", {}}, {true, true, true, true, true, false}, {}},
                   {"root", {"start", {}}, {false, false, false, false, false, true}, {}}};
  const auto p = structure::beam_properties(beam.section, beam.material);
  const double force = 0.1 * p.torsional_stiffness / p.polar_radius_squared;
  const double unloaded = omegas(beam, 10, 1)[0];
  beam.members = {part(beam, "all", 0, 1)};
  beam.members[0].axial_force = force;
  EXPECT_NEAR(std::pow(omegas(beam, 10, 1)[0] / unloaded, 2), 1.1, 1e-9);
}

} // namespace beam_theories_tests
