// Stress at the fibres of tapered, hinged, thick and prestressed members against closed forms.
#include "reduction/beam_bodies.h"

#include <gtest/gtest.h>

namespace member_stress_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

constexpr double width = 0.06;
constexpr double depth = 0.02; // along local z

/// 2 m along x, clamped at the start, moving in the x-z plane; kept whole, so that statics are
/// exact.
BeamDefinition bar() {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(2, 0, 0), 4};
  beam.section.width = width;
  beam.section.thickness = depth;
  beam.material = {200e9, 0.3, 8000};
  beam.plane_normal = 1;
  clamp_start(beam);
  beam.points = {{"tip", {"end", {}}, 0, Vector3::Zero()}};
  return beam;
}

/// Under a static unit force at the tip along x or z.
Vector pushed(const ReducedBody &body, Index axis) {
  return (body.point("tip").rows.row(axis).transpose().array() / body.stiffness.array()).matrix();
}

/// Largest direct stress at the first (0) or second (1) end of a line.
double stress_of(const ReducedBody &body, std::size_t line, Index end, const Vector &q) {
  const CellStress &places = body.recovery.line_stress;
  const Vector stress = places.rows * q;
  const Index half = 3 * (places.first[line + 1] - places.first[line]) / 2;
  double largest = 0;
  for (Index row = 0; row < half; row += 3)
    largest = std::max(largest, std::abs(stress[3 * places.first[line] + end * half + row]));
  return largest;
}

double modulus(double local_depth) { return width * local_depth * local_depth / 6; }

} // namespace

TEST(MemberStress, FibresOfATaperedCantilever) {
  BeamDefinition beam = bar();
  beam.section.end_thickness = depth / 2;
  const ReducedBody body = reduced(beam, 12);
  const Vector q = pushed(body, 2);
  for (std::size_t line = 0; line < 4; ++line)
    for (const Index end : {0, 1}) {
      const double x = 0.5 * static_cast<double>(line + static_cast<std::size_t>(end));
      EXPECT_NEAR(stress_of(body, line, end, q) * modulus(depth * (1 - x / 4)), 2 - x, 1e-6);
    }
}

TEST(MemberStress, ShearDeformationLeavesTheMomentAsItIs) {
  BeamDefinition beam = bar();
  beam.section.thickness = 10 * depth;
  beam.section.theory = structure::BeamTheory::timoshenko;
  const ReducedBody body = reduced(beam, 12);
  EXPECT_NEAR(stress_of(body, 0, 0, pushed(body, 2)) * modulus(10 * depth), 2, 1e-6);
}

// A hinge in the middle, the tip on a roller that is pushed along x and held across by a support in
// the middle: the far half carries no moment, and what remains is the axial stress.
TEST(MemberStress, NoMomentAtAHinge) {
  BeamDefinition beam = bar();
  structure::Member far{.name = "far", .between = {{1, 2}}};
  far.section = beam.section;
  far.material = beam.material;
  beam.members = {far};
  beam.hinges = {{"joint", "far", {"", Vector3(1, 0, 0)}, {}}};
  beam.hinges[0].free[4] = true;
  beam.supports.push_back({"roller", {"end", {}}, {false, false, true, false, false, false}, {}});
  beam.points.push_back({"joint", {"", Vector3(1, 0, 0)}, 0, Vector3::Zero()});
  const ReducedBody body = reduced(beam, 11);
  const Vector across =
      (body.point("joint").rows.row(2).transpose().array() / body.stiffness.array()).matrix();
  EXPECT_NEAR(stress_of(body, 0, 0, across) * modulus(depth), 1, 1e-6); // a cantilever of 1 m
  EXPECT_LT(stress_of(body, 2, 0, across) * modulus(depth), 1e-6);
  EXPECT_LT(stress_of(body, 3, 1, across) * modulus(depth), 1e-6);
}

// A cantilever under a tension N and a force F across at its tip: E I v'' = N (v - v_tip) + F (L -
// x), so that the moment at the clamp is F tanh(k L) / k, k^2 = N / EI.
TEST(MemberStress, MomentOfABeamInTension) {
  BeamDefinition beam = bar();
  beam.line.elements = 16;
  const double bending = 200e9 * width * std::pow(depth, 3) / 12;
  structure::Member all{.name = "all"};
  all.section = beam.section;
  all.material = beam.material;
  all.axial_force = 4 * bending; // k L = 4
  beam.members = {all};
  const ReducedBody body = reduced(beam, 48);
  const Vector q = pushed(body, 2);
  EXPECT_NEAR(stress_of(body, 0, 0, q) * modulus(depth), std::tanh(4.0) / 2, 1e-4);
}

} // namespace member_stress_tests
