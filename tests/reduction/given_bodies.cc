// Bodies from matrices against the same bodies made by this program, on any number of ranks.
#include "reduction/given_bodies.h"

#include "common/decompositions.h"
#include "reduction/beam_bodies.h"
#include "reduction/body_file.h"
#include "temporary_folder.h"
#include "text_of.h"

#include <gtest/gtest.h>

namespace given_bodies_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;
using vibroimpact::testing::TemporaryFolder;
using vibroimpact::testing::text_of;

namespace {

/// In space, so that every component counts; its head carries a mass.
BeamDefinition space_beam() {
  BeamDefinition beam = square_beam(12);
  beam.section.width = 0.004; // simple frequencies
  beam.points.push_back({"middle", {"", Vector3(0.05, 0.1, 0.1)}});
  return beam;
}

/// The same body: matrices of the free beam without its lumped mass, and the rest as given.
BodyDefinition given_body(const BodyDefinition &own, const std::filesystem::path &folder,
                          const Given &given = {}) {
  BodyDefinition definition = own;
  definition.type = BodyDefinition::Type::matrices;
  BeamDefinition bare = own.beam;
  bare.supports.clear();
  bare.points.clear();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::filesystem::create_directories(folder / std::to_string(rank));
  if (rank == 0)
    write_matrices(structure::build_frame(bare), folder, given);
  MPI_Barrier(MPI_COMM_WORLD);
  structure::MatrixDefinition &matrices = definition.matrices;
  matrices.stiffness_file = folder / "k";
  matrices.mass_file = folder / "m";
  matrices.table_name = "t";
  matrices.table_content = text_of(folder / "t");
  matrices.units = given.units;
  matrices.points = own.beam.points;
  matrices.supports = own.beam.supports;
  for (structure::Point &point : matrices.points)
    if (point.at.group == "end")
      point.at = {"", Vector3(0.1, 0.2, 0.2)};
  for (structure::Support &support : matrices.supports)
    support.at = {"", Vector3(0, 0, 0)};
  return definition;
}

void expect_same(const ReducedBody &one, const ReducedBody &other, double tolerance) {
  ASSERT_EQ(one.size(), other.size());
  for (Index j = 0; j < one.size(); ++j)
    EXPECT_NEAR(one.omega()[j], other.omega()[j],
                tolerance * std::max(other.omega()[j], other.omega().maxCoeff() * 1e-6));
  for (std::size_t p = 0; p < one.points.size(); ++p) {
    const BodyPoint &a = one.points[p];
    const BodyPoint &b = other.points[p];
    EXPECT_EQ(a.name, b.name);
    EXPECT_NEAR((a.position - b.position).norm(), 0, 1e-12);
    for (const auto &[x, y] :
         {std::pair(a.rows.topRows(3).eval(), b.rows.topRows(3).eval()),
          std::pair(a.flexibility, b.flexibility), std::pair(a.inverse_mass, b.inverse_mass)}) {
      ASSERT_EQ(x.size(), y.size());
      if (x.size() == 0)
        continue;
      EXPECT_LT((x - y).norm(), 100 * tolerance * y.norm()) << a.name;
    }
  }
  EXPECT_LT((one.base_participation - other.base_participation).norm(),
            100 * tolerance * other.base_participation.norm());
  EXPECT_LT((one.damping - other.damping).norm(), 100 * tolerance * other.damping.norm() + 1e-12);
  EXPECT_LT((one.total_mass - other.total_mass).norm(), tolerance * other.total_mass.norm());
}

ReducedBody make(const BodyDefinition &definition) { return reduce(definition, MPI_COMM_WORLD); }

std::string problem_of_definition(const BodyDefinition &definition) {
  try {
    make(definition);
  } catch (const structure::DefinitionError &error) {
    return error.kind() + "/" + error.key() + " " + error.problem();
  }
  return "";
}

/// Two modes of a body with these entries of K and M.
BodyDefinition from_files(const std::filesystem::path &folder, const std::string &stiffness,
                          const std::string &mass) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::ofstream(folder / "k") << stiffness;
    std::ofstream(folder / "m") << mass;
  }
  MPI_Barrier(MPI_COMM_WORLD);
  BodyDefinition definition;
  definition.type = BodyDefinition::Type::matrices;
  definition.selection.number = 2;
  definition.matrices.stiffness_file = folder / "k";
  definition.matrices.mass_file = folder / "m";
  return definition;
}

} // namespace

TEST(GivenBodies, AreTheBodyTheyWereMadeFrom) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  BodyDefinition own = body_of(space_beam(), 6);
  own.damping.ratios = {0.01};
  own.attachments = {{"head", 0}, {"middle", 2}};
  expect_same(make(given_body(own, folder.path())), make(own), 1e-9);
  own.reduction = BodyDefinition::Reduction::fixed_interface;
  expect_same(make(given_body(own, folder.path())), make(own), 1e-8);
}

TEST(GivenBodies, EveryRankGetsTheSameBytes) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  const std::string own = to_bytes(make(given_body(body_of(space_beam(), 6), folder.path())), "");
  EXPECT_EQ(own, broadcast(own, MPI_COMM_WORLD));
}

TEST(GivenBodies, UnitsOfTheFilesAreTaken) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  const BodyDefinition own = body_of(space_beam(), 6);
  const ReducedBody expected = make(own);
  for (const structure::UnitSystem &units :
       {structure::UnitSystem{.length = 1e-3, .mass = 1e3, .time = 1},
        structure::UnitSystem{.length = 1e-3, .mass = 1, .time = 1e-3}})
    expect_same(make(given_body(own, folder.path(), {.units = units})), expected, 1e-9);
}

TEST(GivenBodies, GivenDampingIsTaken) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  BodyDefinition own = body_of(space_beam(), 6);
  own.attachments = {{"head", 0}};
  own.damping = {.model = Damping::Model::rayleigh, .alpha = 3, .beta = 1e-5};
  const ReducedBody expected = make(own);
  BodyDefinition given =
      given_body(own, folder.path(),
                 {.units = {.length = 1e-3, .mass = 1e3, .time = 1}, .alpha = 3, .beta = 1e-5});
  given.damping = {.model = Damping::Model::given};
  given.matrices.damping_file = folder.path() / "c";
  // The matrices are without the mass of the head, which Rayleigh's damping takes in.
  Matrix head = Matrix::Zero(expected.size(), expected.size());
  const Matrix rows = expected.point("head").rows.topRows(3);
  head = 3 * 0.02 * rows.transpose() * rows;
  const ReducedBody made = make(given);
  EXPECT_LT((made.damping - (expected.damping - head)).norm(), 1e-6 * expected.damping.norm());
}

TEST(GivenBodies, RigidMotionsOfFreeBodiesAreExactlyThat) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  BeamDefinition beam = space_beam();
  beam.supports.clear();
  BodyDefinition own = body_of(beam, 10);
  own.attachments = {{"head", 0}};
  const ReducedBody body = make(given_body(own, folder.path()));
  expect_same(body, make(own), 1e-7);
  EXPECT_EQ((body.stiffness.array() == 0).count(), 6);
}

// Two masses on a line stand for a node that was expanded to two: u_1 + u_2 = 2 u.
TEST(GivenBodies, SeveralRowsOfOneDirectionMoveByTheirMean) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  BodyDefinition definition =
      from_files(folder.path(), "1 1 300\n1 2 -100\n2 2 300\n", "1 1 1\n2 2 1\n");
  definition.matrices.table_content = "3.1 0 0 0\n3.1 0 0 0\n";
  definition.matrices.points = {{"p", {.group = "", .position = {}, .number = 3}}};
  const ReducedBody body = make(definition);
  EXPECT_NEAR(body.stiffness[0], 200, 1e-9);
  EXPECT_NEAR(body.stiffness[1], 400, 1e-9);
  EXPECT_NEAR(std::abs(body.points[0].rows(0, 0)), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(body.points[0].rows(0, 1), 0, 1e-12);
  EXPECT_NEAR(body.points[0].flexibility(0, 0), 1. / 400, 1e-12); // half the force on each spring
  EXPECT_NEAR(body.total_mass[0], 2, 1e-12);
  EXPECT_TRUE(body.recovery.empty());
  EXPECT_EQ(body.points[0].node, -1);
}

// Rows without mass follow statically; a mass matrix may be singular in other ways too.
TEST(GivenBodies, SingularMassesAreCounted) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  // The mass of rows 3 and 4 is that of their sum.
  BodyDefinition definition =
      from_files(folder.path(), "1 1 2\n1 2 -1\n2 2 2\n2 3 -1\n3 3 1\n4 4 5\n",
                 "1 1 3\n3 3 1\n3 4 1\n4 4 1\n");
  definition.matrices.table_content = "1.1 0 0 0\n2.1 1 0 0\n3.1 2 0 0\n4.1 3 0 0\n";
  // K^-1 in the masses' coordinates u_1 and u_3 + u_4: 2/3, 1/3 and ... by hand.
  const double a = 1;
  const double b = 1;
  const double c = 3 + 0.2;
  const Matrix flexibility = (Matrix(2, 2) << a, b, b, c).finished();
  const Matrix mass = Eigen::Vector2d(3, 1).asDiagonal();
  const Vector values = eigenvalues(flexibility * mass).real();
  const ReducedBody body = make(definition);
  EXPECT_NEAR(body.stiffness[0], 1 / values.maxCoeff(), 1e-10);
  EXPECT_NEAR(body.stiffness[1], 1 / values.minCoeff(), 1e-10);
  definition.selection.number = 3;
  EXPECT_NE(problem_of_definition(definition).find("with mass, 2"), std::string::npos);
}

TEST(GivenBodies, BadMatricesAreRefused) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  BodyDefinition definition;
  definition.type = BodyDefinition::Type::matrices;
  definition.selection.number = 1;
  structure::MatrixDefinition &given = definition.matrices;
  given.stiffness_file = folder.path() / "k";
  given.mass_file = folder.path() / "m";
  given.table_content = "1.1 0 0 0\n1.2 0 0 0\n";
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const auto expect = [&](const std::string &k, const std::string &m, const std::string &part) {
    if (rank == 0) {
      std::ofstream(given.stiffness_file) << k;
      std::ofstream(given.mass_file) << m;
    }
    MPI_Barrier(MPI_COMM_WORLD);
    const std::string problem = problem_of_definition(definition);
    EXPECT_NE(problem.find(part), std::string::npos) << problem;
    MPI_Barrier(MPI_COMM_WORLD);
  };
  const std::string sound = "1 1 2\n2 2 2\n";
  const std::string general = "%%MatrixMarket matrix coordinate real general\n2 2 4\n";
  expect(sound, sound, "");
  EXPECT_EQ(problem_of_definition(definition), "");
  expect("1 1 2\n", sound,
         "Stiffness must have a diagonal greater than 0, but that of row 2 "
         "(node 1, direction 2) is 0");
  expect("1 1 2\n1 1 2\n2 2 2\n", sound, "Stiffness must have each entry once");
  expect(general + "1 1 2\n1 2 1\n2 1 0.5\n2 2 2\n", sound, "Stiffness must be symmetric");
  expect("1 1 2\n1 2 3\n2 2 2\n", sound, "Stiffness must be positive semidefinite");
  expect(sound, "1 1 2\n2 2 -2\n", "Mass must be positive semidefinite, but the diagonal of row 2");
  expect(sound, "1 1 2\n1 2 3\n2 2 2\n", "Mass must be positive semidefinite, but row 1");
  expect(sound, "1 2 3\n", "Mass must be positive semidefinite");
  given.table_content = "1.1\n1.2\n";
  expect(sound, sound, "Table must have the coordinates of its nodes");
  given.deck_content = "*NODE\n7,0,0,0\n";
  expect(sound, sound, "Table must have nodes of the input deck");
  given.deck_content = "*NODE\n1,0,0,0\n";
  given.points = {{"p", {.group = "", .position = {}, .number = 9}}};
  expect(sound, sound, "Point/Node must be the number of a node");
}

} // namespace given_bodies_tests
