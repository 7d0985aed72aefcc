// The derivative of motions with friction along two directions by their start, against differences.
#include "contact/friction/planar_coulomb.h"
#include "contact/friction/planar_spring_slider.h"
#include "contact/friction/viscous.h"
#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt.h"
#include "motion/variation/linearised_motion.h"
#include "support/motion_derivative.h"
#include "support/planar_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::motion {
namespace planar_variation_tests {

using namespace model;
using contact::ContactLaw;
using contact::ContactSet;
using contact::CoulombConstants;
using contact::FrictionalLaw;
using contact::PlanarCoulomb;
using contact::PlanarSpringSlider;
using contact::SpringSliderConstants;
using contact::TangentialLaw;
using testing::across_the_ground;
using testing::on_the_ground;
using testing::precise;
using testing::Sled;
using testing::sled_model;

/// Deviations of places and speeds, in their sizes.
void expect_derivative(const Sled &sled, const std::shared_ptr<const ContactLaw> &law,
                       const Vector &sizes, double end, double error) {
  const Model model = sled_model(sled);
  const ContactSet contacts({on_the_ground(model, law, across_the_ground())});
  Trajectory trajectory(model, contacts, precise("exact"));
  const Index size = trajectory.layout().physical_size();
  Vector start = Vector::Zero(size);
  start.head(6) = Eigen::Map<const Vector>(sled.start.data(), 6);
  Vector scale = Vector::Constant(size, sizes[0]);
  scale.head(6) = sizes;
  const auto image = [&](const Vector &from) {
    trajectory.start({.time = 0, .physical = from});
    trajectory.advance(end);
    return Vector(trajectory.motion_state().physical.head(6).cwiseQuotient(sizes));
  };
  trajectory.start({.time = 0, .physical = start});
  Variation variation(trajectory, scale.cwiseInverse(), 1e-12);
  variation.set_columns(Matrix::Identity(size, size));
  trajectory.advance(end, variation);
  const Matrix columns =
      sizes.cwiseInverse().asDiagonal() * variation.columns().topRows(6) * scale.asDiagonal();
  for (const Index j : {0, 4}) {
    const auto difference = testing::numerical_derivative(
        [&](double h) {
          return std::optional(image(start + h * scale[j] * Vector::Unit(size, j)));
        },
        1e-3, 4);
    EXPECT_LT((difference.value - columns.col(j)).cwiseAbs().maxCoeff(),
              error * std::max(1.0, difference.value.cwiseAbs().maxCoeff()))
        << law->name() << ", t = " << end << ", column " << j << ": " << difference.error << "\n"
        << difference.value.transpose() << "\n"
        << columns.col(j).transpose();
  }
}

std::vector<std::shared_ptr<const TangentialLaw>> sliders(double stiffness, double coefficient,
                                                          double dashpot) {
  return {std::make_shared<PlanarSpringSlider>(
              SpringSliderConstants{.stiffness = stiffness, .coefficient = coefficient}),
          std::make_shared<PlanarSpringSlider>(SpringSliderConstants{
              .stiffness = stiffness, .coefficient = coefficient, .damping_constant = dashpot}),
          std::make_shared<contact::Viscous>(dashpot, 2)};
}

const Sled pressed{
    .mass = 1, .kx = 1, .ky = 1.7, .driven = true, .start = {1.5, 0.5, 0, 0.2, -1, 0}};

TEST(PlanarVariation, PressedSled) {
  for (const auto &friction : sliders(20, 0.1, 0.8))
    expect_derivative(pressed, testing::constant_with(10, friction), Vector::Ones(6), 6, 1e-7);
}

// In stick speeds have been forgotten, but for what the slip rate leaves at which a stop begins.
TEST(PlanarVariation, PressedSledThatStops) {
  const auto friction = std::make_shared<PlanarCoulomb>(
      CoulombConstants{.coefficient = 0.1, .static_coefficient = 0.12});
  for (const double end : {6.0, 10.0})
    expect_derivative(pressed, testing::constant_with(10, friction), Vector::Ones(6), end, 1e-6);
}

TEST(PlanarVariation, ObliqueImpacts) {
  const Sled flying{.mass = 2, .kx = 4e5, .ky = 1e5, .start = {0, 0, 0.099, 0.3, 0.2, 1}};
  const Vector sizes{{1e-3, 1e-3, 1e-2, 0.5, 0.5, 1}};
  const std::vector<std::shared_ptr<const ContactLaw>> normals = {
      std::make_shared<contact::KelvinVoigt>(3e4, 90),
      std::make_shared<contact::Hertz>(contact::HertzConstants{.stiffness = 1e5})};
  for (const auto &normal : normals)
    for (const auto &friction : sliders(2e5, 0.3, 150))
      for (const double end : {0.017, 0.03})
        if (friction->damping_constant() > 0 || friction->stiffness() == 0)
          expect_derivative(flying, std::make_shared<FrictionalLaw>(normal, friction), sizes, end,
                            1e-6);
}

} // namespace planar_variation_tests
} // namespace vibroimpact::motion
