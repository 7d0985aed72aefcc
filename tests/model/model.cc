// The dense equations of motion: assembly of bodies, loads, base motions, projections.
#include "model/model.h"
#include "model/direction.h"
#include "model/initial_condition.h"
#include "support/rotor_models.h"

#include "common/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::model {
namespace model_tests {

using reduction::ReducedBody;
using testing::single_mass;

TEST(ModelTest, HarmonicIsItsOwnDerivatives) {
  for (const Given given : {Given::displacement, Given::velocity, Given::acceleration}) {
    const Harmonic function(given, 2.5, 7.0, 0.3);
    for (const double t : {0.0, 0.1, 1.7}) {
      const double h = 1e-5;
      EXPECT_NEAR(function.rate(t), (function.value(t + h) - function.value(t - h)) / (2 * h),
                  1e-6);
      EXPECT_NEAR(function.acceleration(t), (function.rate(t + h) - function.rate(t - h)) / (2 * h),
                  1e-5);
      const double wanted = 2.5 * std::sin(7 * t + 0.3);
      const double is = given == Given::displacement ? function.value(t)
                        : given == Given::velocity   ? function.rate(t)
                                                     : function.acceleration(t);
      EXPECT_NEAR(is, wanted, 1e-12);
    }
  }
}

TEST(ModelTest, FrequencyChangeKeepsWhatIsGiven) {
  const Harmonic function(Given::acceleration, 3, 10, 0);
  const auto faster = function.with_frequency(20);
  EXPECT_NEAR(faster->acceleration(M_PI / 40), 3, 1e-12);
  EXPECT_NEAR(faster->period(), M_PI / 10, 1e-15);
}

TEST(ModelTest, BodiesStandSideBySide) {
  const Model model({single_mass("a", 2, 30, 0.4), single_mass("b", 5, 0, 0)});
  EXPECT_EQ(model.size(), 2);
  EXPECT_EQ(model.mass(), Eigen::Vector2d(2, 5));
  EXPECT_EQ(model.stiffness().diagonal, Eigen::Vector2d(30, 0));
  EXPECT_EQ(model.damping().coupling.size(), 0);
  EXPECT_EQ(model.point_names(), (std::vector<std::string>{"a.head", "b.head"}));
  EXPECT_NEAR(model.highest_frequency(), std::sqrt(15.0), 1e-14);
}

// The no-load speed of a motor, 40 / 0.8, its time constant and its initial speed count as well.
TEST(ModelTest, HighestFrequencyOfRotors) {
  const auto highest = [](const std::optional<Motor> &motor, double initial_speed) {
    Model model({testing::plane_mass("frame", 2, 32, 0), testing::rotation("disc", 1)});
    testing::put_rotor(model, 1, "frame.head", 1, 0.1, motor, initial_speed);
    return model.highest_frequency();
  };
  const Motor motor{.starting_torque = 40, .slope = 0.8, .time_constant = 0.1};
  Motor quick = motor;
  quick.time_constant = 0.001;
  EXPECT_DOUBLE_EQ(highest(std::nullopt, 0), 4);
  EXPECT_DOUBLE_EQ(highest(std::nullopt, -20), 20);
  EXPECT_DOUBLE_EQ(highest(motor, 0), 50);
  EXPECT_DOUBLE_EQ(highest(quick, 0), 1000);
}

TEST(ModelTest, BaseMotionLoadsAndCarriesItsBodies) {
  Model model({single_mass("a", 2, 30, 0), single_mass("b", 5, 10, 0)});
  model.add_base_motion("ground", std::make_shared<Harmonic>(Given::displacement, 0.1, 3, M_PI / 2),
                        {0}, Vector3::UnitX());
  Vector load;
  model.load(0, load);
  EXPECT_NEAR(load[0], 2 * 0.1 * 9, 1e-14); // -m s'' with s'' = -0.1 * 9
  EXPECT_EQ(load[1], 0);
  EXPECT_NEAR(model.base_displacement(0, 0)[0], 0.1, 1e-15);
  EXPECT_EQ(model.base_displacement(1, 0)[0], 0);
  const PointReference head{.body = 0, .point = 0};
  EXPECT_EQ(model.displacement(head, Vector3::UnitX(), true).base_coefficients[0], 1);
  EXPECT_EQ(model.displacement(head, Vector3::UnitX(), false).base_coefficients[0], 0);
  EXPECT_EQ(model.displacement(head, Vector3::UnitY(), true).base_coefficients[0], 0);
}

TEST(ModelTest, FullDampingMatrixIsKept) {
  auto body = std::make_shared<ReducedBody>(*single_mass("a", 1, 1, 0));
  body->mass = Eigen::Vector2d(1, 1);
  body->stiffness = Eigen::Vector2d(4, 9);
  body->damping = Matrix::Constant(2, 2, 0.5);
  body->base_participation = Matrix::Zero(2, 3);
  body->points[0].rows = Matrix::Zero(6, 2);
  const Model model({body});
  EXPECT_EQ(model.damping().dense(), Matrix::Constant(2, 2, 0.5));
  Vector product;
  const Vector x = Eigen::Vector2d(1, 3);
  model.damping().apply(ConstVectorView(x.data(), 2), product);
  EXPECT_EQ(product, Eigen::Vector2d(2, 2));
}

TEST(ModelTest, StaticDeflectionIsThatOfAPointForce) {
  ReducedBody body = *single_mass("a", 1, 1, 0);
  body.mass = Eigen::Vector2d(1, 1);
  body.stiffness = Eigen::Vector2d(4, 100);
  body.points[0].rows = Matrix::Zero(6, 2);
  body.points[0].rows.row(0) << 2, 3;
  const Vector shape = static_deflection(body, body.points[0], Vector3::UnitX(), 0.01);
  // q = phi F / k with F such that phi . q = 0.01
  const double force = 0.01 / (4.0 / 4 + 9.0 / 100);
  EXPECT_NEAR(shape[0], 2 * force / 4, 1e-15);
  EXPECT_NEAR(shape[1], 3 * force / 100, 1e-15);
  body.stiffness[0] = 0;
  EXPECT_THROW(static_deflection(body, body.points[0], Vector3::UnitX(), 0.01), NumericalError);
  EXPECT_THROW(static_deflection(body, body.points[0], Vector3::UnitY(), 0.01), NumericalError);
}

// What the forces take from the coordinates and the base puts in is what the springs store: along a
// motion, d/dt energy = -f . v + power of the base. The floor carries the first block alone, so
// that a spring to the floor, one to the ground and one between the blocks see it in different
// ways.
TEST(ModelTest, CubicSpringsStoreTheWorkOfTheBlocksAndTheBase) {
  Model model({single_mass("a", 1, 0, 0), single_mass("b", 1, 0, 0)});
  model.add_base_motion("floor", std::make_shared<Harmonic>(Given::displacement, 0.3, 5, 0.2), {0},
                        Vector3::UnitX());
  const Projection a = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), true);
  const Projection b = model.displacement({.body = 1, .point = 0}, Vector3::UnitX(), true);
  const Projection relative = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  const Projection between{.row = b.row - a.row,
                           .base_coefficients = {b.base_coefficients[0] - a.base_coefficients[0]}};
  const std::vector<Projection> elongations = {a, relative, between};
  for (std::size_t i = 0; i < elongations.size(); ++i)
    model.add_connection({.name = "spring" + std::to_string(i),
                          .side_a = "a.head",
                          .side_b = "ground",
                          .elongation = elongations[i],
                          .cubic_stiffness = 1.0 + static_cast<double>(i)});
  const auto position = [](double t) -> Vector {
    return Eigen::Vector2d(std::sin(2 * t), 0.5 * std::cos(3 * t));
  };
  const auto energy = [&](double t) {
    const Vector q = position(t);
    return model.cubic_energy(t, ConstVectorView(q.data(), 2));
  };
  for (const double t : {0.1, 0.7, 1.9}) {
    const Vector q = position(t);
    const Vector v = Eigen::Vector2d(2 * std::cos(2 * t), -1.5 * std::sin(3 * t));
    Vector force = Vector::Zero(2);
    const double base_power =
        model.add_cubic_forces(t, ConstVectorView(q.data(), 2), VectorView(force.data(), 2));
    constexpr double h = 1e-4;
    const double stored = (energy(t + h) - energy(t - h)) / (2 * h);
    EXPECT_NEAR(stored, base_power - force.dot(v), 1e-5) << t;
    EXPECT_GT(std::abs(base_power), 0.01) << t;
  }
}

TEST(ModelTest, Directions) {
  EXPECT_EQ(*parse_direction("x"), Vector3::UnitX());
  EXPECT_EQ(*parse_direction(" -z "), -Vector3::UnitZ());
  EXPECT_TRUE(parse_direction("3, 0, 4")->isApprox(Vector3(0.6, 0, 0.8)));
  for (const char *wrong : {"", "w", "xy", "1, 2", "0, 0, 0", "1, a, 2", "1, 2, 3, 4", "nan, 0, 1"})
    EXPECT_FALSE(parse_direction(wrong)) << wrong;
}

} // namespace model_tests
} // namespace vibroimpact::model
