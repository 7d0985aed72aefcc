// Modes of several bodies with connections: closed forms, an independent dense solver, damping that
// couples modes, ties.
#include "model/assembled_system.h"

#include "common/decompositions.h"
#include "common/error.h"
#include "model/side.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

namespace vibroimpact::model {
namespace assembled_system_tests {

using testing::single_mass;

void connect(Model &model, const std::string &a, const std::string &b, double stiffness,
             double damping = 0) {
  model.add_connection(
      {.name = a + b,
       .side_a = a,
       .side_b = b,
       .elongation = relative_displacement({.a = a, .b = b}, Vector3::UnitX(), model),
       .stiffness = stiffness,
       .damping = damping});
}

// Masses m between walls, neighbours joined by k: omega_j = 2 sqrt(k/m) sin(j pi / (2 (n + 1))).
TEST(AssembledSystemTest, ChainBetweenWalls) {
  constexpr int n = 7;
  constexpr double k = 30, m = 2;
  std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
  for (int i = 0; i < n; ++i)
    bodies.push_back(single_mass("m" + std::to_string(i), m, i == 0 || i == n - 1 ? k : 0, 0));
  Model model(bodies);
  for (int i = 0; i + 1 < n; ++i)
    connect(model, "m" + std::to_string(i) + ".head", "m" + std::to_string(i + 1) + ".head", k);
  const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
  EXPECT_EQ(modes.rigid, 0);
  EXPECT_TRUE(modes.modal_damping);
  for (int j = 1; j <= n; ++j)
    EXPECT_NEAR(modes.angular_frequency()[j - 1],
                2 * std::sqrt(k / m) * std::sin(j * std::numbers::pi / (2 * (n + 1))), 1e-13);
  const Matrix masses = modes.shapes.transpose() * model.mass().asDiagonal() * modes.shapes;
  EXPECT_LT((masses - Matrix::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-14);
}

// Two masses that only a spring joins, with stiff neighbours: the rigid motion is exact.
TEST(AssembledSystemTest, RigidModeAndItsPoints) {
  Model model({single_mass("a", 2, 0, 0), single_mass("b", 5, 0, 0), single_mass("c", 1, 1e12, 0)});
  connect(model, "a.head", "b.head", 7, 0.5);
  const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
  EXPECT_EQ(modes.rigid, 1);
  EXPECT_EQ(modes.stiffness[0], 0);
  EXPECT_NEAR(modes.stiffness[1], 7 * (1.0 / 2 + 1.0 / 5), 1e-13);
  EXPECT_NEAR(modes.damping_ratio()[1], 0.5 * 0.7 / (2 * std::sqrt(4.9)), 1e-14);
  EXPECT_EQ(moved_points(model, modes.shapes.col(0)), "a.head along x and b.head along x");
  EXPECT_EQ(unheld_motions(model),
            "; no spring holds the whole system against the motion of a.head "
            "along x and b.head along x");
}

Model random_system(std::mt19937 &generator) {
  std::uniform_real_distribution<double> uniform(0.5, 2);
  std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
  for (int i = 0; i < 6; ++i)
    bodies.push_back(single_mass("m" + std::to_string(i), uniform(generator),
                                 50 * uniform(generator), uniform(generator)));
  Model model(bodies);
  for (int i = 0; i < 5; ++i)
    connect(model, "m" + std::to_string(i) + ".head",
            "m" + std::to_string((2 * i + 1) % 6) + ".head", 100 * uniform(generator),
            i == 1 ? 20 : 0.1);
  return model;
}

// lambda^2 M + lambda C + K by the generalised problem of Eigen, which shares nothing with it.
TEST(AssembledSystemTest, DampedModesOfAnotherSolver) {
  std::mt19937 generator(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Model model = random_system(generator);
    const Index n = model.size();
    Matrix a = Matrix::Zero(2 * n, 2 * n), b = Matrix::Identity(2 * n, 2 * n);
    a.topRightCorner(n, n).setIdentity();
    a.bottomLeftCorner(n, n) = -model.stiffness().dense();
    a.bottomRightCorner(n, n) = -model.damping().dense();
    b.bottomRightCorner(n, n) = model.mass().asDiagonal();
    const Eigen::GeneralizedEigenSolver<Matrix> other(a, b);
    const AssembledModes modes = assembled_modes(model, AssembledSystem(model));
    EXPECT_FALSE(modes.modal_damping);
    const DampedModes damped = damped_modes(modes);
    for (Index j = 0; j < damped.eigenvalues.size(); ++j) {
      const std::complex<double> lambda = damped.eigenvalues[j];
      EXPECT_LT((other.eigenvalues().array() - lambda).abs().minCoeff(), 1e-12 * std::abs(lambda));
      const ComplexVector shape = damped.shapes.col(j);
      const ComplexMatrix dynamic = lambda * lambda * Matrix(model.mass().asDiagonal()) +
                                    lambda * model.damping().dense() + model.stiffness().dense();
      const ComplexVector residual = dynamic * shape;
      EXPECT_LT(residual.norm(), 1e-11 * (model.stiffness().dense() * shape).norm());
    }
  }
}

TEST(AssembledSystemTest, OverdampedMotionsOnlyDecay) {
  Model model({single_mass("a", 1, 6, 5), single_mass("b", 2, 50, 0)});
  connect(model, "a.head", "b.head", 0, 0.3);
  const DampedModes damped = damped_modes(assembled_modes(model, AssembledSystem(model)));
  EXPECT_EQ(damped.eigenvalues.size(), 3); // two that decay, a pair that vibrates
  EXPECT_EQ((damped.eigenvalues.imag().array() == 0).count(), 2);
}

// Tied, both masses are one; that is the limit of a spring that gets stiffer, as 1 / its stiffness.
TEST(AssembledSystemTest, TiesAreTheLimitOfStiffSprings) {
  const auto system = [](double stiffness) {
    Model model(
        {single_mass("a", 2, 30, 1), single_mass("b", 5, 10, 0), single_mass("c", 3, 9, 0)});
    connect(model, "b.head", "c.head", 4);
    if (stiffness > 0)
      connect(model, "a.head", "b.head", stiffness);
    return model;
  };
  const Model model = system(0);
  Matrix tie = Matrix::Zero(2, 3);
  tie.row(0) << -1, 1, 0;
  tie.row(1) << -2, 2, 0; // said twice
  const AssembledModes tied = assembled_modes(model, AssembledSystem(model, tie));
  ASSERT_EQ(tied.stiffness.size(), 2);
  EXPECT_LT((tied.shapes.row(0) - tied.shapes.row(1)).norm(), 1e-15);
  EXPECT_NEAR(tied.stiffness.sum(), 44.0 / 7 + 13.0 / 3, 1e-13); // the trace
  for (const double stiffness : {1e4, 1e6}) {
    const Model stiff = system(stiffness);
    const Vector values = assembled_modes(stiff, AssembledSystem(stiff)).stiffness.head(2);
    EXPECT_LT((values - tied.stiffness).cwiseAbs().maxCoeff(), 100 / stiffness);
  }
  EXPECT_THROW(AssembledSystem(model, Matrix::Identity(3, 3)), NumericalError);
}

} // namespace assembled_system_tests
} // namespace vibroimpact::model
