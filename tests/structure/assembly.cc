#include "structure/assembly.h"

#include "modes/factorisation.h"
#include "modes/vector_block.h"
#include "structure/beam_examples.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace assembly_tests {

using namespace vibroimpact;
using namespace vibroimpact::structure;
using modes::Layout;

namespace {

AssembledBody assembled(const BeamDefinition &beam) {
  return assemble(build_frame(beam), MPI_COMM_WORLD);
}

// Values at free degrees of freedom for one vector of every rank, from a rule per node, component.
template <class Rule> modes::Block own_vector(const AssembledBody &body, Rule rule) {
  Matrix all = Matrix::Zero(body.free.size, 1);
  for (std::size_t node = 0; node < body.free.number.size(); ++node)
    for (int component = 0; component < 6; ++component)
      if (body.free.number[node][component] >= 0)
        all(body.free.number[node][component], 0) = rule(static_cast<int>(node), component);
  return modes::own_rows(Layout(body.stiffness.get()), all);
}

Matrix solved(const AssembledBody &body, const modes::Block &load) {
  const modes::Factorisation factorised(body.stiffness.get(), body.mass.get(), 0);
  return gather(Layout(body.stiffness.get()), factorised.solve(load));
}

BeamDefinition skew_beam() {
  BeamDefinition beam = examples::thin_beam(7);
  beam.line.start = {0.1, 0.2, -0.1};
  beam.line.end = {0.25, 0.4, 0.3};
  beam.section.thickness = 0.01;
  beam.points.push_back({"head", {"end", {}}, 0.3, {1e-4, 2e-4, 3e-4}});
  return beam;
}

} // namespace

TEST(Assembly, HeldDegreesOfFreedomAreLeftOut) {
  const AssembledBody body = assembled(examples::cantilever(10));
  EXPECT_EQ(body.free.size, 20);
  EXPECT_EQ(body.free.number[0], (std::array<int, 6>{-1, -1, -1, -1, -1, -1}));
  EXPECT_GE(body.free.number[5][0], 0);
  EXPECT_EQ(body.free.number[5][1], -1);
  PetscInt rows = 0;
  MatGetSize(body.stiffness.get(), &rows, nullptr);
  EXPECT_EQ(rows, 20);
}

TEST(Assembly, TipForceBendsLikeTheTextbook) {
  const BeamDefinition beam = examples::cantilever(10);
  const AssembledBody body = assembled(beam);
  const modes::Block force = own_vector(body, [](int node, int i) { return node == 10 && i == 0; });
  const double deflection = solved(body, force)(body.free.number[10][0], 0);
  const double expected = std::pow(0.3, 3) / (3 * examples::bending_stiffness(beam));
  EXPECT_NEAR(deflection, expected, 1e-9 * expected);
}

TEST(Assembly, ElasticSupportActsInSeries) {
  BeamDefinition beam = examples::cantilever(4);
  beam.supports.push_back({"spring", {"end", {}}, {}, {50, 0, 0, 0, 0, 0}});
  const AssembledBody body = assembled(beam);
  const modes::Block force = own_vector(body, [](int node, int i) { return node == 4 && i == 0; });
  const double stiffness = 3 * examples::bending_stiffness(beam) / std::pow(0.3, 3) + 50;
  EXPECT_NEAR(solved(body, force)(body.free.number[4][0], 0) * stiffness, 1, 1e-10);
}

TEST(Assembly, OperatorAndMatrixAgree) {
  BeamDefinition beam = skew_beam();
  examples::clamp_start(beam);
  beam.supports.push_back({"spring", {"end", {}}, {}, {1e4, 2e4, 3e4, 40, 50, 60}});
  const AssembledBody body = assembled(beam);
  const modes::Block x = own_vector(body, [](int node, int i) { return std::sin(7.0 * node + i); });
  const modes::Block by_matrix = modes::multiply(body.stiffness.get(), x);
  const modes::Block by_element = modes::multiply(body.accurate_stiffness->matrix(), x);
  const Layout layout(body.stiffness.get());
  const Matrix difference = gather(layout, by_matrix - by_element);
  EXPECT_LT(difference.norm(), 1e-13 * gather(layout, by_matrix).norm());
}

TEST(Assembly, RigidMotionOfAFreeBodyCausesNoForce) {
  const AssembledBody body = assembled(skew_beam());
  const Vector3 rotation(0.3, -0.2, 0.5);
  const auto rigid = [&](int node, int i) {
    const Vector3 moved = Vector3(1, 2, 3) + rotation.cross(body.model.mesh.nodes[node]);
    return i < 3 ? moved[i] : rotation[i - 3];
  };
  const Layout layout(body.stiffness.get());
  const modes::Block x = own_vector(body, rigid);
  const Matrix force = gather(layout, modes::multiply(body.accurate_stiffness->matrix(), x));
  double norm = 0;
  MatNorm(body.stiffness.get(), NORM_INFINITY, &norm);
  EXPECT_LT(force.cwiseAbs().maxCoeff(), 1e-14 * norm);
}

TEST(Assembly, BaseInertiaOfAFreeBodyIsMassTimesTranslation) {
  const AssembledBody body = assembled(skew_beam());
  const Layout layout(body.mass.get());
  for (int axis = 0; axis < 3; ++axis) {
    const modes::Block r = own_vector(body, [&](int, int i) { return i == axis; });
    const Matrix inertia = gather(layout, modes::multiply(body.mass.get(), r));
    EXPECT_LT((inertia - body.base_inertia.col(axis)).norm(), 1e-13 * inertia.norm());
    EXPECT_NEAR(modes::inner_products(layout, r, modes::multiply(body.mass.get(), r))(0, 0),
                body.model.total_mass(), 1e-13 * body.model.total_mass());
  }
}

TEST(Assembly, DistributedMassHasNoLumpedPart) {
  const AssembledBody body = assembled(skew_beam());
  EXPECT_NEAR(body.model.distributed_mass(), body.model.total_mass() - 0.3, 1e-13);
}

// In a beam along x its axial motion, its torsion and its bending in either plane have no entry in
// common: ten of a block's 36 are left, six where the parts of two equal elements cancel.
TEST(Assembly, EntriesThatAreZeroInBothMatricesAreLeftOut) {
  const AssembledBody body = assembled(examples::thin_beam(40));
  const auto entries = [](Mat matrix) {
    MatInfo information;
    MatGetInfo(matrix, MAT_GLOBAL_SUM, &information);
    return information.nz_used;
  };
  const int nodes = 41;
  const double outside = 10 * 2 * (nodes - 1);
  EXPECT_LE(entries(body.stiffness.get()), outside + 10 * nodes);
  EXPECT_GE(entries(body.stiffness.get()), outside + 6 * (nodes - 2) + 20);
  EXPECT_EQ(entries(body.mass.get()), entries(body.stiffness.get()));
}

TEST(Assembly, BodiesThatCannotMoveOrHaveNoMassAreRefused) {
  BeamDefinition held = examples::thin_beam(3);
  held.supports.push_back({"all", {"all", {}}, {true, true, true, true, true, true}, {}});
  EXPECT_THROW(assembled(held), DefinitionError);
  BeamDefinition massless = examples::thin_beam(3);
  massless.material.density = 0;
  EXPECT_THROW(assembled(massless), DefinitionError);
  massless.points.push_back({"head", {"end", {}}, 1, Vector3::Zero()});
  EXPECT_EQ(assembled(massless).massive_dofs, 3);
}

TEST(Assembly, APointIsOneNode) {
  BeamDefinition beam = examples::thin_beam(3);
  beam.points.push_back({"everywhere", {"all", {}}, 0, Vector3::Zero()});
  EXPECT_THROW(assembled(beam), DefinitionError);
}

} // namespace assembly_tests
