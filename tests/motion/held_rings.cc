// What holds rigid sides together in circular gaps: where they rest, and the derivatives of rates.
#include "model/time_function.h"
#include "motion/system/equilibrium.h"
#include "support/circular_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace held_rings_tests {

using namespace model;
using contact::ContactSet;
using testing::isotropic;
using testing::ring_about_z;
using testing::vector_of;

std::shared_ptr<const contact::ContactLaw> newton(double restitution) {
  return std::make_shared<contact::NewtonRestitution>(restitution);
}

// On a spring under a slanted load: where load, spring and normal force lie along one line.
TEST(HeldRings, EquilibriumOnTheWall) {
  const double c = 0.02, k = 40;
  for (const double angle : {0.3, 1.9, -2.4}) {
    const Model model({isotropic("ball", 1.5, k, 0)});
    const ContactSet contacts({ring_about_z(model, "ball.head", "", c, newton(0.5))});
    const Vector direction = vector_of({std::cos(angle), std::sin(angle)});
    const Equilibrium pressed = static_equilibrium(model, contacts, 3 * k * c * direction);
    EXPECT_TRUE(pressed.closed[0]);
    EXPECT_LT((pressed.displacement - c * direction).norm(), 1e-14);
    const Equilibrium free = static_equilibrium(model, contacts, 0.5 * k * c * direction);
    EXPECT_FALSE(free.closed[0]);
    EXPECT_LT((free.displacement - 0.5 * c * direction).norm(), 1e-16);
  }
}

// The derivative of the rates, in every mode that holds the gap, against differences; masses and
// springs differ by direction.
TEST(HeldRings, JacobianAgainstDifferences) {
  auto body = std::make_shared<reduction::ReducedBody>(*isotropic("ball", 1, 40, 0.3));
  body->mass = vector_of({1.3, 0.8});
  body->stiffness = vector_of({40, 70});
  Model model({body});
  model.add_gravity("weight", make_constant(Given::displacement, 9.81), {0}, -Vector3::UnitY());
  const ContactSet contacts({ring_about_z(model, "ball.head", "", 0.3, newton(0.5),
                                          std::make_shared<contact::Coulomb>(0.4, 0.4), 0.7)});
  Equations equations(model, contacts);
  const StateLayout &layout = equations.layout();
  for (std::size_t mode = 1; mode < contacts.pairs()[0].law->modes().size(); ++mode) {
    equations.set_mode(0, static_cast<int>(mode));
    Vector x = Vector::Zero(layout.size());
    x.head(4) = vector_of({0.18, -0.25, 0.4, 0.31});
    Matrix jacobian;
    equations.jacobian(0.2, ConstVectorView(x.data(), x.size()), jacobian);
    const double h = 1e-6;
    for (Index j = 0; j < 4; ++j) {
      const auto rates = [&](double shift) {
        Vector at = x, made(layout.size());
        at[j] += shift;
        equations.rates(0.2, ConstVectorView(at.data(), at.size()),
                        VectorView(made.data(), made.size()));
        return Vector(made.head(4));
      };
      const Vector difference = (rates(h) - rates(-h)) / (2 * h);
      EXPECT_LT((difference - jacobian.col(j).head(4)).norm(), 1e-7 * (1 + difference.norm()))
          << mode << " " << j << "\n"
          << difference.transpose() << "\n"
          << jacobian.col(j).head(4).transpose();
    }
  }
}

} // namespace held_rings_tests
} // namespace vibroimpact::motion
