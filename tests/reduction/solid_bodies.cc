// Bodies of solids: what a parameter file says about them, their reduction and their stress.
#include "reduction/parameter_files.h"
#include "reduction/reduce.h"
#include "structure/solid_examples.h"

#include <gtest/gtest.h>

namespace solid_bodies_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

constexpr std::array<bool, 6> everything = {true, true, true, true, true, true};

/// A bar along x without Poisson effect, pulled at its end.
BodyDefinition bar() {
  BodyDefinition definition;
  definition.name = "bar";
  definition.type = BodyDefinition::Type::solid;
  definition.solid = solid_block({1, 0.02, 0.02}, {10, 2, 2}, {2e11, 0, 7800});
  hold(definition.solid, "left", everything);
  hold(definition.solid, "all", {false, true, true, false, false, false});
  definition.solid.points.push_back({.name = "tip", .at = {"", Vector3(1, 0.01, 0.01)}});
  definition.solid.links.push_back({.name = "face", .groups = {"right"}});
  definition.solid.loads.push_back(
      {.name = "pull", .at = {"", Vector3(1, 0.01, 0.01)}, .force = {800, 0, 0}});
  definition.attachments = {{.point = "tip", .axis = 0}};
  definition.selection.number = 3;
  return definition;
}

} // namespace

// The attachment holds the static answer: F L / E A, and s_xx = F / A everywhere.
TEST(SolidBodies, StressOfAPulledBarHasSixComponents) {
  const ReducedBody body = reduce(bar(), MPI_COMM_WORLD);
  EXPECT_EQ(body.type, "solid");
  ASSERT_EQ(body.recovery.cells.size(), 40U);
  EXPECT_EQ(body.recovery.cells[0].shape, structure::CellShape::hexahedron);
  EXPECT_TRUE(body.recovery.lines.empty());
  const BodyPoint &tip = body.point("tip");
  EXPECT_NEAR(tip.static_displacement[0], 800 / (2e11 * 4e-4), 1e-18);
  const Vector q = 800 * (tip.rows.row(0).transpose().array() / body.stiffness.array()).matrix();
  const CellStress &places = body.recovery.cell_stress;
  ASSERT_EQ(places.components, 6);
  ASSERT_EQ(places.first.back(), 40);
  const Vector stress = places.rows * q;
  for (Index cell = 0; cell < 40; ++cell) {
    EXPECT_NEAR(stress[6 * cell], 2e6, 1e-2);
    EXPECT_LT(stress.segment(6 * cell + 1, 5).norm(), 1e-2);
    EXPECT_NEAR(std::sqrt(squared_von_mises(&stress[6 * cell], 6)), 2e6, 1e-2);
  }
  ASSERT_EQ(tip.stress_components, 6);
  EXPECT_NEAR((tip.stress * q)[0], 2e6, 1e-2);
}

// Pure shear s_xy = t: sqrt(3) t; hydrostatic pressure: none. Plane stress is the same in both
// forms.
TEST(SolidBodies, VonMisesStressOfSixComponents) {
  const std::array<double, 6> shear = {0, 0, 0, 2, 0, 0};
  EXPECT_DOUBLE_EQ(squared_von_mises(shear.data(), 6), 12);
  const std::array<double, 6> pressure = {-3, -3, -3, 0, 0, 0};
  EXPECT_EQ(squared_von_mises(pressure.data(), 6), 0);
  const std::array<double, 6> plane = {5, -2, 0, 1, 0, 0};
  const std::array<double, 3> same = {5, -2, 1};
  EXPECT_DOUBLE_EQ(squared_von_mises(plane.data(), 6), squared_von_mises(same.data(), 3));
}

} // namespace solid_bodies_tests
