// Damping of the modes of the whole system: ratios of a chain, alpha M + beta K, bases that move.
#include "model/system_damping.h"

#include "model/assembled_system.h"
#include "model/side.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::model {
namespace system_damping_tests {

using testing::single_mass;

void damp(Model &model, const std::string &keys) {
  const auto root = std::make_shared<parameters::Section>("", "");
  declare_system_damping(*root);
  const auto set = parameters::ParameterSet::parse(
      root, "subsection System damping\n" + keys + "end\n", "test.prm", false);
  add_system_damping(set->root(), model);
}

void connect(Model &model, const std::string &a, const std::string &b, double stiffness,
             double damping) {
  model.add_connection(
      {.name = a + b,
       .side_a = a,
       .side_b = b,
       .elongation = relative_displacement({.a = a, .b = b}, Vector3::UnitX(), model),
       .stiffness = stiffness,
       .damping = damping});
}

/// Three masses in a row; the first on a spring and a base that shakes, the last on one that rests.
Model chain(bool shaken) {
  Model model({single_mass("a", 2, 30, 0), single_mass("b", 1, 0, 0), single_mass("c", 3, 40, 0)});
  if (shaken)
    model.add_base_motion("floor", std::make_shared<Harmonic>(Given::displacement, 0.1, 3, 0.4),
                          {0}, Vector3::UnitX());
  connect(model, "a.head", "b.head", 50, 0);
  connect(model, "b.head", "c.head", 70, 0);
  return model;
}

TEST(SystemDampingTest, EachModeHasItsRatioAndTheLastOneRepeats) {
  Model model = chain(false);
  damp(model, "set Damping ratio = 0.02, 0.05\n");
  const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
  EXPECT_TRUE(modes.modal_damping);
  EXPECT_TRUE(modes.damping_ratio().isApprox(Eigen::Vector3d(0.02, 0.05, 0.05), 1e-14));
}

TEST(SystemDampingTest, IsAddedToDashpots) {
  Model model = chain(false), undamped = chain(false);
  connect(undamped, "a.head", "c.head", 0, 2);
  connect(model, "a.head", "c.head", 0, 2);
  const Matrix before = undamped.damping().dense();
  damp(model, "set Damping ratio = 0.1\n");
  const AssembledModes modes = assembled_modes(undamped, AssembledSystem(undamped));
  const Matrix added = modes.shapes.transpose() * (model.damping().dense() - before) * modes.shapes;
  const Matrix expected = Vector(0.2 * modes.angular_frequency()).asDiagonal();
  EXPECT_TRUE(added.isApprox(expected, 1e-14));
}

TEST(SystemDampingTest, RayleighDampingIsThatOfTheMatrices) {
  Model model = chain(false);
  damp(model, "set Damping model = rayleigh\nset Rayleigh alpha = 0.3/s\n"
              "set Rayleigh beta = 2 ms\n");
  const Matrix expected =
      0.3 * Matrix(model.mass().asDiagonal()) + 2e-3 * model.stiffness().dense();
  EXPECT_TRUE(model.damping().dense().isApprox(expected, 1e-14));
}

// With x the displacements in space and u the rest position for a base at s, M x'' + C (x' - u')
// + K (x - u) = 0; a counts from its base, so that C (q' - u') has the same C and u - (s, 0, 0).
TEST(SystemDampingTest, SlowMotionsOfABaseBringNoForce) {
  Model model = chain(true);
  damp(model, "set Damping ratio = 0.02, 0.05\n");
  const Source &floor = model.sources()[0];
  const Vector rest = model.stiffness().dense().lu().solve(floor.load); // per s, as q
  EXPECT_GT(rest.norm(), 0.1);
  EXPECT_TRUE(floor.rate_load.isApprox(model.damping().dense() * rest, 1e-13));
}

// The same with an end of a connection that moves.
TEST(SystemDampingTest, SlowMotionsOfASupportBringNoForce) {
  Model model({single_mass("a", 2, 0, 0), single_mass("b", 1, 60, 0)});
  model.add_base_motion("support", std::make_shared<Harmonic>(Given::displacement, 0.1, 3, 0.4), {},
                        Vector3::UnitX());
  Projection elongation =
      relative_displacement({.a = "a.head", .b = side_ground}, Vector3::UnitX(), model);
  elongation.base_coefficients[0] += 1;
  model.add_connection({.name = "held",
                        .side_a = "a.head",
                        .side_b = side_ground,
                        .elongation = elongation,
                        .stiffness = 20});
  connect(model, "a.head", "b.head", 50, 0);
  damp(model, "set Damping ratio = 0.02, 0.05\n");
  const Vector rest = model.stiffness().dense().lu().solve(model.sources()[0].load);
  EXPECT_GT(rest.norm(), 0.1);
  EXPECT_TRUE(model.sources()[0].rate_load.isApprox(model.damping().dense() * rest, 1e-13));
}

TEST(SystemDampingTest, RigidMotionsAreNotDampedByRatios) {
  Model model({single_mass("a", 2, 0, 0), single_mass("b", 5, 0, 0)});
  connect(model, "a.head", "b.head", 7, 0);
  damp(model, "set Damping ratio = 0.1\n");
  EXPECT_LT((model.damping().dense() * Vector::Ones(2)).norm(), 1e-15);
  const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
  EXPECT_NEAR(modes.damping_ratio()[1], 0.1, 1e-15);
}

TEST(SystemDampingTest, ChangesWithTheDampingOfTheRest) {
  Model model = chain(true);
  connect(model, "a.head", "c.head", 0, 2);
  damp(model, "set Damping ratio = 0.02\n");
  const Matrix before = model.damping().dense();
  const Vector load = model.sources()[0].rate_load;
  model.change_damping(0.5, 0);
  EXPECT_TRUE(model.damping().dense().isApprox(before / 2, 1e-15));
  EXPECT_TRUE(model.sources()[0].rate_load.isApprox(load / 2, 1e-15));
}

} // namespace system_damping_tests
} // namespace vibroimpact::model
