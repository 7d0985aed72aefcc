// Springs and dashpots between points: matrices, loads of moving bases, cubic forces.
#include "model/model.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::model {
namespace connection_tests {

using testing::single_mass;

Projection along_x(const Model &model, const std::string &a, const std::string &b) {
  PointReference from, to;
  model.find_point(a, from);
  Projection difference = model.displacement(from, Vector3::UnitX(), true);
  difference.row *= -1;
  for (double &base_coefficients : difference.base_coefficients)
    base_coefficients *= -1;
  if (model.find_point(b, to)) {
    const Projection other = model.displacement(to, Vector3::UnitX(), true);
    difference.row += other.row;
    for (std::size_t k = 0; k < difference.base_coefficients.size(); ++k)
      difference.base_coefficients[k] += other.base_coefficients[k];
  }
  return difference;
}

TEST(ConnectionTest, CouplesTwoBodies) {
  Model model({single_mass("a", 2, 30, 0), single_mass("b", 5, 0, 1)});
  model.add_connection({.name = "link",
                        .side_a = "a.head",
                        .side_b = "b.head",
                        .elongation = along_x(model, "a.head", "b.head"),
                        .stiffness = 7,
                        .damping = 0.5});
  Matrix stiffness(2, 2), damping(2, 2);
  stiffness << 37, -7, -7, 7;
  damping << 0.5, -0.5, -0.5, 1.5;
  EXPECT_EQ(model.stiffness().dense(), stiffness);
  EXPECT_EQ(model.damping().dense(), damping);
  EXPECT_TRUE(model.linear());
}

// C becomes C / 2 - 0.1 M, also where bodies and connections are looked at by themselves.
TEST(ConnectionTest, DampingIsLeftOutAndMassesExcited) {
  Model model({single_mass("a", 2, 30, 0), single_mass("b", 5, 0, 1)});
  model.add_connection({.name = "link",
                        .side_a = "a.head",
                        .side_b = "b.head",
                        .elongation = along_x(model, "a.head", "b.head"),
                        .damping = 0.5});
  model.change_damping(0.5, 0.1);
  Matrix damping(2, 2);
  damping << 0.05, -0.25, -0.25, 0.25;
  EXPECT_TRUE(model.damping().dense().isApprox(damping, 1e-15));
  EXPECT_EQ(model.connections()[0].damping, 0.25);
  EXPECT_EQ(model.bodies()[0]->damping(0, 0), -0.2);
  EXPECT_EQ(model.bodies()[1]->damping(0, 0), 0);
}

// A mass on the floor tied to one on a shaken base: the tie pulls with k s + c s'.
TEST(ConnectionTest, MovingBaseLoadsTheOtherEnd) {
  Model model({single_mass("floor", 2, 30, 0), single_mass("shaken", 5, 10, 0)});
  const auto history = std::make_shared<Harmonic>(Given::displacement, 0.1, 3, 0.4);
  model.add_base_motion("ground", history, {1}, Vector3::UnitX());
  model.add_connection({.name = "link",
                        .side_a = "floor.head",
                        .side_b = "shaken.head",
                        .elongation = along_x(model, "floor.head", "shaken.head"),
                        .stiffness = 7,
                        .damping = 0.5});
  const double t = 0.3;
  Vector load;
  model.load(t, load);
  const double tension = 7 * history->value(t) + 0.5 * history->rate(t);
  EXPECT_NEAR(load[0], tension, 1e-14);
  EXPECT_NEAR(load[1], -tension - 5 * history->acceleration(t), 1e-13);
}

TEST(ConnectionTest, CubicSpringIsTheGradientOfItsEnergy) {
  Model model({single_mass("a", 2, 0, 0), single_mass("b", 5, 0, 0)});
  model.add_connection({.name = "link",
                        .side_a = "a.head",
                        .side_b = "b.head",
                        .elongation = along_x(model, "a.head", "b.head"),
                        .cubic_stiffness = 11});
  EXPECT_FALSE(model.linear());
  const Vector q = Eigen::Vector2d(0.3, -0.4);
  const double h = 1e-6;
  Vector force = Vector::Zero(2);
  model.add_cubic_forces(0, ConstVectorView(q.data(), 2), VectorView(force.data(), 2));
  Matrix stiffness = Matrix::Zero(2, 2);
  model.add_cubic_stiffness(0, ConstVectorView(q.data(), 2), stiffness);
  for (Index j = 0; j < 2; ++j) {
    Vector up = q, down = q;
    up[j] += h;
    down[j] -= h;
    const double slope = (model.cubic_energy(0, ConstVectorView(up.data(), 2)) -
                          model.cubic_energy(0, ConstVectorView(down.data(), 2))) /
                         (2 * h);
    EXPECT_NEAR(force[j], -slope, 1e-8);
    Vector force_up = Vector::Zero(2), force_down = Vector::Zero(2);
    model.add_cubic_forces(0, ConstVectorView(up.data(), 2), VectorView(force_up.data(), 2));
    model.add_cubic_forces(0, ConstVectorView(down.data(), 2), VectorView(force_down.data(), 2));
    EXPECT_TRUE(stiffness.col(j).isApprox((force_down - force_up) / (2 * h), 1e-8));
  }
}

} // namespace connection_tests
} // namespace vibroimpact::model
