// How a body answers impulses at its points before it is reduced.
#include "reduction/point_response.h"
#include "reduction/beam_bodies.h"
#include "structure/shell_benchmarks.h"

#include <gtest/gtest.h>

namespace point_response_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

BodyDefinition shell_of(const ShellDefinition &shell, int number) {
  BodyDefinition definition;
  definition.name = "plate";
  definition.type = BodyDefinition::Type::shell;
  definition.shell = shell;
  definition.selection.number = number;
  return definition;
}

/// Phi Phi^T of the displacements: what the kept coordinates know of the inverse mass.
Matrix kept_inverse_mass(const BodyPoint &point) {
  const Matrix displacements = point.rows.topRows(3);
  return displacements * displacements.transpose();
}

} // namespace

// One element, clamped at its start: its mass matrix rho A L / 420 (156, -22 L; -22 L, 4 L^2) has
// the inverse 12 / (rho A L) for the tip, and rho A L / 3 is left along the axis.
TEST(PointResponse, OneElementHasTheInverseOfItsMassMatrix) {
  for (const double lumped : {0.0, 0.02}) {
    BeamDefinition beam = thin_beam(1);
    clamp_start(beam);
    beam.points.push_back({"head", {"end", {}}, lumped, Vector3::Zero()});
    const Matrix inverse = reduced(beam, 2).point("head").inverse_mass;
    EXPECT_NEAR(inverse(0, 0) * (beam_mass(beam) / 12 + lumped), 1, 1e-12);
    EXPECT_NEAR(inverse(2, 2) * (beam_mass(beam) / 3 + lumped), 1, 1e-12);
    EXPECT_NEAR(inverse(0, 2), 0, 1e-12 * inverse(2, 2));
  }
}

// With all modes kept M^-1 = Phi Phi^T, in a skew body too, whose x, y and z are coupled.
TEST(PointResponse, AllModesKnowTheWholeInverseMass) {
  for (const bool held : {true, false}) {
    BeamDefinition beam = square_beam(3);
    if (!held)
      beam.supports.clear();
    const BodyPoint head = reduced(beam, held ? 18 : 24).point("head");
    EXPECT_GT(std::abs(head.inverse_mass(0, 1)), 1e-3 * head.inverse_mass(0, 0));
    EXPECT_LT((kept_inverse_mass(head) - head.inverse_mass).norm(),
              1e-9 * head.inverse_mass.norm());
    EXPECT_EQ(head.flexibility.size() > 0, held);
  }
}

TEST(PointResponse, FewerModesKnowLess) {
  ShellDefinition shell = simply_supported_plate(4, CellShape::quadrilateral);
  shell.points.push_back({"middle", {"", Vector3(5, 5, 0)}, 0, {0, 0, 0}});
  double before = 0;
  for (const int number : {1, 5, 20}) {
    const BodyPoint point = reduce(shell_of(shell, number), MPI_COMM_WORLD).points[0];
    const double share = kept_inverse_mass(point)(2, 2) / point.inverse_mass(2, 2);
    EXPECT_GT(share, before);
    EXPECT_LT(share, 1);
    before = share;
  }
}

// What a beam without density carries has its own mass, and the bare beam has none.
TEST(PointResponse, PlacesWithoutMassAreNotKnown) {
  BeamDefinition beam = cantilever(4, 0.02);
  beam.material.density = 0;
  beam.points.push_back({"belly", {"", Vector3(0, 0, 0.15)}, 0, Vector3::Zero()});
  const ReducedBody body = reduced(beam, 1);
  EXPECT_NEAR(body.point("head").inverse_mass(0, 0), 1 / 0.02, 1e-10);
  EXPECT_EQ(body.point("belly").inverse_mass.size(), 0);
}

} // namespace point_response_tests
