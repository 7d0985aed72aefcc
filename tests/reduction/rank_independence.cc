// One body on any number of ranks: the distributed solution against the one of each rank alone.
#include "reduction/beam_bodies.h"
#include "reduction/body_file.h"
#include "structure/shell_examples.h"
#include "structure/solid_examples.h"

#include <gtest/gtest.h>

namespace rank_independence_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;

namespace {

/// Modes of one frequency are free to mix, but for the rule. Vectors are as good as the root of the
/// error of their eigenvalues.
void expect_same_shapes(const ReducedBody &together, const ReducedBody &alone) {
  const Matrix &shapes = alone.recovery.shapes;
  ASSERT_EQ(together.recovery.shapes.rows(), shapes.rows());
  for (Index j = 0; j < shapes.cols(); ++j)
    EXPECT_LT((together.recovery.shapes.col(j) - shapes.col(j)).norm(), 1e-5 * shapes.col(j).norm())
        << "mode " << j + 1;
}

void expect_same(const BodyDefinition &definition) {
  const ReducedBody together = reduce(definition, MPI_COMM_WORLD);
  const ReducedBody alone = reduce(definition, MPI_COMM_SELF);
  ASSERT_EQ(together.size(), alone.size());
  for (Index j = 0; j < alone.size(); ++j)
    EXPECT_NEAR(together.omega()[j], alone.omega()[j], 1e-10 * alone.omega()[j]);
  for (std::size_t i = 0; i < alone.points.size(); ++i)
    for (Index kind = 0; kind < 2; ++kind) {
      const Matrix rows = alone.points[i].rows.middleRows(3 * kind, 3);
      EXPECT_LT((together.points[i].rows.middleRows(3 * kind, 3) - rows).cwiseAbs().maxCoeff(),
                1e-8 * rows.cwiseAbs().maxCoeff());
    }
  EXPECT_LT((together.damping - alone.damping).norm(), 1e-8 * alone.damping.norm());
  expect_same_shapes(together, alone);
}

void expect_same_bytes(const BodyDefinition &definition) {
  const std::string own = to_bytes(reduce(definition, MPI_COMM_WORLD), "");
  EXPECT_EQ(own, broadcast(own, MPI_COMM_WORLD));
}

BodyDefinition free_beam() {
  BeamDefinition beam = square_beam(30);
  beam.supports.clear();
  return body_of(beam, 14);
}

} // namespace

TEST(RankIndependence, TunedCantilever) {
  BodyDefinition definition = body_of(tuned_cantilever(100), 20);
  definition.damping = {.model = Damping::Model::viscous, .viscous_constant = 0.2};
  expect_same(definition);
  expect_same_bytes(definition);
}

TEST(RankIndependence, FineMesh) {
  BodyDefinition definition = body_of(tuned_cantilever(400), 20);
  definition.damping.ratios = {0.01};
  expect_same(definition);
}

TEST(RankIndependence, DoubleFrequencies) {
  BodyDefinition definition = body_of(square_beam(40), 9);
  definition.damping.ratios = {0.01};
  expect_same(definition);
  expect_same_bytes(definition);
}

TEST(RankIndependence, FreeBody) {
  BodyDefinition definition = free_beam();
  definition.damping.ratios = {0.01};
  expect_same(definition);
}

TEST(RankIndependence, FewerElementsThanRanks) {
  BodyDefinition definition = body_of(tuned_cantilever(1), 2);
  definition.damping.ratios = {0.01};
  expect_same(definition);
}

TEST(RankIndependence, ShellWithStiffenerLoadsAndAttachments) {
  BodyDefinition definition;
  definition.name = "panel";
  definition.type = BodyDefinition::Type::shell;
  structure::ShellDefinition &shell = definition.shell;
  shell = square_plate(6, CellShape::triangle);
  structure::Stiffener rib;
  rib.name = "rib";
  rib.on = "bottom";
  rib.section.width = rib.section.thickness = 0.1;
  rib.material = shell.parts[0].material;
  rib.offset = {0, -0.08};
  shell.stiffeners.push_back(rib);
  shell.supports.push_back({"wall", {"left", {}}, hold_all, {}});
  shell.points.push_back({"corner", {"", Vector3(10, 10, 0)}, 100, {1, 1, 1}});
  shell.loads.push_back(weight({0, 0, -9.81}));
  definition.selection.number = 8;
  definition.attachments = {{"corner", 2}};
  definition.damping.ratios = {0.01};
  expect_same(definition);
  expect_same_bytes(definition);
  const ReducedBody together = reduce(definition, MPI_COMM_WORLD);
  const ReducedBody alone = reduce(definition, MPI_COMM_SELF);
  EXPECT_LT((together.recovery.static_displacement - alone.recovery.static_displacement).norm(),
            1e-9 * alone.recovery.static_displacement.norm());
  EXPECT_LT((together.points[0].flexibility - alone.points[0].flexibility).norm(),
            1e-9 * alone.points[0].flexibility.norm());
}

// Motions across the section come in pairs, and the face at the point does not turn in them.
TEST(RankIndependence, SolidBarOfSquareSection) {
  BodyDefinition definition;
  definition.name = "bar";
  definition.type = BodyDefinition::Type::solid;
  definition.solid = solid_block({1, 0.02, 0.02}, {40, 2, 2}, {2e11, 0, 7800});
  hold(definition.solid, "all", {false, true, true, false, false, false});
  definition.solid.points.push_back({.name = "head", .at = {"", Vector3(1, 0.01, 0.01)}});
  definition.solid.links.push_back({.name = "face", .groups = {"right"}});
  definition.selection.number = 20;
  definition.damping.ratios = {0.01};
  expect_same_shapes(reduce(definition, MPI_COMM_WORLD), reduce(definition, MPI_COMM_SELF));
  expect_same_bytes(definition);
}

// Two equal sides: pairs of modes in which the point in the middle stands still.
TEST(RankIndependence, SquarePlateWithPairsOfModes) {
  BodyDefinition definition;
  definition.name = "plate";
  definition.type = BodyDefinition::Type::shell;
  definition.shell = square_plate(8, CellShape::quadrilateral);
  for (const char *edge : {"left", "right", "bottom", "top"})
    definition.shell.supports.push_back({edge, {edge, {}}, hold_all, {}});
  definition.shell.points.push_back({"middle", {"", Vector3(5, 5, 0)}, 0, Vector3::Zero()});
  definition.selection.number = 12;
  definition.damping.ratios = {0.01};
  expect_same(definition);
}

TEST(RankIndependence, MembersHingesPrestressAndMassesBesideTheAxis) {
  BeamDefinition beam = square_beam(12);
  beam.section.theory = structure::BeamTheory::timoshenko;
  structure::Member arm{.name = "arm", .between = {{0.1, 0.2}}};
  arm.section = {.width = 0.004, .thickness = 0.006, .end_thickness = 0.003};
  arm.material = {70e9, 0.33, 2700};
  arm.axial_force = 20;
  beam.members = {arm};
  const Vector3 joint = beam.line.start + (beam.line.end - beam.line.start) * (0.2 / 0.3);
  beam.hinges = {{"joint", "arm", {"", joint}, {false, false, false, false, true, false}}};
  beam.points[0].offset = Vector3(0.01, 0, 0.005);
  beam.points[0].rotary_inertia = Vector3(1e-5, 2e-5, 3e-5);
  beam.points[0].products_of_inertia = Vector3(1e-6, 2e-6, 0);
  BodyDefinition definition = body_of(beam, 12);
  definition.damping.ratios = {0.01};
  expect_same(definition);
  expect_same_bytes(definition);
}

TEST(RankIndependence, RigidLinks) {
  BeamDefinition beam = square_beam(24);
  const auto along = [&](double share) {
    return structure::Location{"", (1 - share) * beam.line.start + share * beam.line.end};
  };
  beam.supports.push_back({"skew", along(0.5), {}, {1e3, 0, 2e3, 0, 0, 0}});
  beam.points.push_back({"low", along(0.25), 0, Vector3::Zero()});
  beam.points.push_back({"middle", along(0.5), 0.03, Vector3(1e-5, 2e-5, 3e-5)});
  beam.links = {{.name = "far", .groups = {"end"}, .points = {"low"}},
                {.name = "near", .points = {"low", "middle"}}};
  BodyDefinition definition = body_of(beam, 12);
  definition.attachments = {{"middle", 0}, {"head", 1}, {"head", 2}};
  definition.damping.ratios = {0.01};
  expect_same(definition);
  expect_same_bytes(definition);
}

TEST(RankIndependence, TheSameRunGivesTheSameBody) {
  const BodyDefinition definition = body_of(square_beam(30), 9);
  const ReducedBody first = reduce(definition, MPI_COMM_WORLD);
  const ReducedBody second = reduce(definition, MPI_COMM_WORLD);
  const double scale = first.recovery.shapes.cwiseAbs().maxCoeff();
  EXPECT_LT((first.recovery.shapes - second.recovery.shapes).cwiseAbs().maxCoeff(), 1e-9 * scale);
}

} // namespace rank_independence_tests
