// Static displacements of plates and shells against closed forms and public cases.
#include "modes/solve_shell.h"
#include "structure/shell_benchmarks.h"

#include <gtest/gtest.h>

namespace shell_statics_tests {

using namespace vibroimpact;
using namespace vibroimpact::examples;

namespace {

constexpr std::array both = {CellShape::quadrilateral, CellShape::triangle};

double roof(int elements, CellShape shape) {
  return static_at_point(scordelis_lo_roof(elements, shape))[2] / scordelis_lo_reference;
}
double cylinder(int elements, CellShape shape) {
  return static_at_point(pinched_cylinder(elements, shape))[2] / pinched_cylinder_reference;
}

double twisted(const TwistedBeam &beam) {
  return static_at_point(twisted_beam(beam))[beam.axis] / twisted_beam_reference(beam);
}

// Cantilever strip of length 1 and width 0.2, thickness t, no Poisson effect, loaded at its end.
ShellDefinition strip(double thickness, CellShape shape, const Vector3 &force, int across = 1) {
  ShellDefinition shell;
  shell.plate = structure::Plate{.corner = {0, 0, 0},
                                 .first_end = {1, 0, 0},
                                 .second_end = {0, 0.2, 0},
                                 .elements = {20, across},
                                 .shape = shape};
  shell.parts.push_back({"strip", "all", thickness, {2e11, 0, 8000}});
  shell.supports.push_back({"root", {"left", {}}, hold_all, {}});
  shell.points.push_back({"tip", {"", Vector3(1, 0, 0)}, 0, {0, 0, 0}});
  shell.loads.push_back(force_at("end", {"right", {}}, force / (across + 1)));
  return shell;
}

} // namespace

TEST(ShellStatics, ScordelisLoRoof) {
  for (const CellShape shape : both)
    EXPECT_NEAR(roof(16, shape), 1, 0.01);
}

TEST(ShellStatics, PinchedCylinder) {
  EXPECT_NEAR(cylinder(40, CellShape::quadrilateral), 1, 0.01);
  EXPECT_NEAR(cylinder(64, CellShape::triangle), 1, 0.01);
}

// Warped elements neither lock as they become thin, nor on a mesh whose lines are not those of the
// surface.
TEST(ShellStatics, TwistedBeam) {
  for (const int axis : {1, 2})
    for (const double thickness : {0.32, 0.0032}) {
      EXPECT_NEAR(twisted({.axis = axis, .thickness = thickness}), 1, 0.02) << axis << thickness;
      EXPECT_NEAR(
          twisted({.along = 24, .across = 4, .axis = axis, .thickness = thickness, .skewed = true}),
          1, 0.005)
          << axis << thickness;
    }
}

// Thin, curved both ways against each other, bending with little stretching: warped elements, and
// flat ones that meet at angles.
TEST(ShellStatics, HyperbolicParaboloid) {
  EXPECT_NEAR(static_at_point(hypar(16, true))[2] / hypar_straight_reference, 1, 0.01);
  EXPECT_NEAR(static_at_point(hypar(16, false))[2] / hypar_reference, 1, 0.05);
}

// Twist passes from element to element by the drilling rotation: a drilling too weak everywhere
// makes the hook diverge.
TEST(ShellStatics, RaaschsHook) {
  EXPECT_NEAR(static_at_point(raasch_hook(18, 3))[2] / raasch_hook_reference, 1, 0.05);
  EXPECT_NEAR(static_at_point(raasch_hook(72, 10))[2] / raasch_hook_reference, 1, 0.01);
}

// Flat elements of a sphere, drilling about the normals of the smooth surface.
TEST(ShellStatics, Hemisphere) {
  EXPECT_NEAR(static_at_point(hemisphere(8))[0] / hemisphere_reference, 1, 0.02);
}

// P L^3 / 3 E I + P L / (5/6 G A), thin and thick.
TEST(ShellStatics, StripBendsAndShears) {
  for (const CellShape shape : both)
    for (const double thickness : {0.001, 0.5}) {
      const double stiffness = 2e11 * 0.2 * std::pow(thickness, 3) / 12;
      const double shear = 5.0 / 6 * 1e11 * 0.2 * thickness;
      const double exact = 10 / (3 * stiffness) + 10 / shear;
      EXPECT_NEAR(static_at_point(strip(thickness, shape, {0, 0, 10}))[2] / exact, 1, 0.002)
          << thickness;
    }
}

// In a strip bent within its plane the drilling rotation is that of the beam, P (L x - x^2 / 2) / E
// I away from the forces, and the deflection of the tip P L^3 / 3 E I with 3 E I / (5/6 G A L^2) =
// 0.6 (b/L)^2 more for the shear.
TEST(ShellStatics, DrillingIsARotationOfTheMaterial) {
  for (const CellShape shape : both) {
    const double stiffness = 2e11 * 0.01 * std::pow(0.2, 3) / 12;
    ShellDefinition shell = strip(0.01, shape, {0, 10, 0}, 4);
    EXPECT_NEAR(static_at_point(shell)[1] / (10 / (3 * stiffness)), 1.024, 0.01);
    shell.points[0].at.position = Vector3(0.75, 0.1, 0);
    EXPECT_NEAR(static_at_point(shell)[5] / (10 * 0.46875 / stiffness), 1, 0.01);
  }
}

TEST(ShellStatics, WeightAndPressureOfAPlate) {
  // Simply supported square under uniform load q: w = 0.00406235 q a^4 / D in the middle (Navier).
  ShellDefinition shell = simply_supported_plate(16);
  shell.points.push_back({"middle", {"", Vector3(5, 5, 0)}, 0, {0, 0, 0}});
  const double bending = 200e9 * std::pow(0.05, 3) / (12 * 0.91);
  const double exact = 0.00406235 * 1e4 / bending;
  shell.loads = {pressure(100)};
  EXPECT_NEAR(static_at_point(shell)[2] / (100 * exact), 1, 0.005);
  shell.loads = {weight({0, 0, -2})};
  EXPECT_NEAR(static_at_point(shell)[2] / (-800 * exact), 1, 0.005);
}

// A beam under the strip's middle line, at a distance: together they bend about their common
// centre, E I = sum (E I + E A e^2), and the displacement is that of one beam.
TEST(ShellStatics, AnEccentricStiffenerActsTogetherWithTheShell) {
  ShellDefinition shell;
  shell.plate = structure::Plate{
      .corner = {0, 0, 0}, .first_end = {1, 0, 0}, .second_end = {0, 0.02, 0}, .elements = {40, 1}};
  shell.parts.push_back({"strip", "all", 0.002, {2e11, 0, 8000}});
  shell.supports.push_back({"root", {"left", {}}, hold_all, {}});
  // Half a beam along each edge, so that nothing twists.
  for (const char *edge : {"bottom", "top"}) {
    structure::Stiffener stiffener;
    stiffener.name = stiffener.on = edge;
    stiffener.section.width = 0.004;
    stiffener.section.thickness = 0.006;
    stiffener.material = {2e11, 0, 8000};
    stiffener.offset = {0, -0.004};
    shell.stiffeners.push_back(stiffener);
  }
  shell.points.push_back({"tip", {"", Vector3(1, 0, 0)}, 0, {0, 0, 0}});
  shell.loads.push_back(force_at("end", {"right", {}}, {0, 0, 5}));
  const double plate_area = 0.02 * 0.002;
  const double beam_area = 2 * 0.004 * 0.006;
  const double centre = -0.004 * beam_area / (plate_area + beam_area);
  const double second_moment = plate_area * (0.002 * 0.002 / 12 + centre * centre) +
                               beam_area * (0.006 * 0.006 / 12 + std::pow(0.004 + centre, 2));
  EXPECT_NEAR(static_at_point(shell)[2] / (10 / (3 * 2e11 * second_moment)), 1, 0.003);
}

// The sum of the reactions is the load: what the supports feel follows from the free rows.
TEST(ShellStatics, LoadsAddUp) {
  ShellDefinition shell = strip(0.01, CellShape::triangle, {1, 2, 3});
  shell.loads.push_back(weight({0, 0, -10}));
  shell.loads.push_back(pressure(7));
  shell.supports.clear();
  const structure::AssembledBody body = assembled(shell);
  Vector3 sum = Vector3::Zero();
  for (const auto &node : body.free.number)
    for (int axis = 0; axis < 3; ++axis)
      sum[axis] += body.load[node[axis]];
  const double mass = 8000 * 0.2 * 0.01;
  EXPECT_LT((sum - Vector3(1, 2, 3 - 10 * mass + 7 * 0.2)).norm(), 1e-10);
}

} // namespace shell_statics_tests
