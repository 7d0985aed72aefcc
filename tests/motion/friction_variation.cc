// The derivative of motions with friction by their start, against closed multipliers.
#include "common/decompositions.h"
#include "contact/friction/lugre.h"
#include "contact/friction/piecewise_linear.h"
#include "contact/friction/spring_slider.h"
#include "contact/friction/stribeck.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "model/time_function.h"
#include "motion/variation/linearised_motion.h"
#include "support/friction_models.h"
#include "support/motion_derivative.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace friction_variation_tests {

using namespace model;
using contact::ContactSet;
using testing::Changes;
using testing::constant_with;
using testing::coulomb;
using testing::settings_of;
using testing::single_mass;
using testing::sliding_along_x;
using testing::vector_of;
constexpr double pi = std::numbers::pi;

// From where the trajectory stands.
Matrix monodromy(Trajectory &trajectory, double period) {
  const Index size = trajectory.layout().physical_size();
  Variation variation(trajectory, Vector::Ones(size), 1e-11);
  variation.set_columns(Matrix::Identity(size, size));
  trajectory.advance(trajectory.time() + period, variation);
  EXPECT_EQ(variation.tangential_events(), 0);
  return variation.columns();
}

std::vector<Complex> multipliers(const Matrix &monodromy) {
  const Eigen::VectorXcd values = eigenvalues(monodromy);
  std::vector<Complex> list(values.begin(), values.end());
  std::sort(list.begin(), list.end(), [](Complex a, Complex b) {
    return std::pair(a.real(), a.imag()) < std::pair(b.real(), b.imag());
  });
  return list;
}

// Without stops: two turns per period, each a jump of the acceleration by 2 f.
TEST(FrictionVariation, ForcedMotionWithoutStops) {
  const double b = 1.2, f = 0.4;
  const double v = 1 / (1 - b * b), u = std::sin(pi / b) / (b * (1 + std::cos(pi / b)));
  const double a = std::sqrt(v * v - u * u * f * f);
  const double s = (a * b * b - f) / (a * b * b + f), c = std::cos(pi / b);
  Model model({single_mass("block", 1, 1, 0)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 1, b, pi / 2),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(f, 1, 1))});
  Trajectory trajectory(model, contacts, settings_of("exact"));
  trajectory.start(0, vector_of({a}), vector_of({0}));
  const double period = 2 * pi / b;
  trajectory.advance(200.1 * period);
  const std::vector<Complex> found = multipliers(monodromy(trajectory, period));
  const Complex root = std::sqrt(Complex(c * c * (1 + s) * (1 + s) / 4 - s));
  const Complex expected = std::pow(c * (1 + s) / 2 - root, 2);
  EXPECT_NEAR(found[0].real(), expected.real(), 1e-11);
  EXPECT_NEAR(std::abs(found[0].imag()), std::abs(expected.imag()), 1e-11);
  EXPECT_NEAR(found[0].real(), .3969261601, 1e-10);
  EXPECT_NEAR(std::abs(found[0].imag()), .6306157782, 1e-10);
}

// With a stop at every turn the speed is forgotten there: 0; and what is left of a deviation of the
// place is that of the way from one stop to the next, against differences.
TEST(FrictionVariation, ForcedMotionWithStops) {
  const double b = 0.6, f = 0.6, period = 2 * pi / b;
  Model model({single_mass("block", 1, 1, 0.02)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 1, b, pi / 2),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(f, 1, 1.2))});
  Trajectory trajectory(model, contacts, settings_of("exact"));
  trajectory.start(0, vector_of({1.4}), vector_of({0}));
  trajectory.advance(20.4 * period);
  const MotionState slips = trajectory.motion_state();
  const auto image = [&](const Vector &from) {
    trajectory.start({.time = slips.time, .physical = from});
    trajectory.advance(slips.time + period);
    return trajectory.motion_state().physical;
  };
  trajectory.start(slips);
  Changes changes(contacts);
  Variation variation(trajectory, Vector::Ones(2), 1e-11);
  variation.set_columns(Matrix::Identity(2, 2));
  Observers both({&variation, &changes});
  trajectory.advance(slips.time + period, both);
  const Matrix columns = variation.columns();
  ASSERT_EQ(changes.list.size(), 4u);
  for (Index j = 0; j < 2; ++j) {
    const double h = 1e-4;
    const auto difference = [&](double step) {
      const Vector by = step * Vector::Unit(2, j);
      return Vector((image(slips.physical + by) - image(slips.physical - by)) / (2 * step));
    };
    const Vector expected = (4 * difference(h / 2) - difference(h)) / 3;
    EXPECT_LT((expected - columns.col(j)).cwiseAbs().maxCoeff(), 1e-9) << j;
  }
  EXPECT_NEAR(std::abs(multipliers(columns)[0]), 0, 1e-12);
}

// On a belt nothing says when the motion begins: 1; and sticking forgets all else: 0.
TEST(FrictionVariation, StickSlipOnABelt) {
  for (const double mu_s : {1.0, 0.5 + 1e-3}) {
    const double mu = 0.5, belt = 0.2, drop = mu_s - mu;
    const Model model({single_mass("block", 1, 1, 0)});
    const ContactSet contacts(
        {sliding_along_x(model, "block.head", "", coulomb(1, mu, mu_s), belt)});
    Trajectory trajectory(model, contacts, settings_of("exact"));
    trajectory.start(0, vector_of({0}), vector_of({belt}));
    const double period = 2 * drop / belt + 2 * (pi - std::atan(drop / belt));
    double slip = mu_s / belt; // the first one begins
    while (slip < 20)
      slip += period;
    trajectory.advance(slip + 1);
    const std::vector<Complex> found = multipliers(monodromy(trajectory, period));
    EXPECT_NEAR(std::abs(found[0]), 0, 1e-10) << mu_s;
    EXPECT_NEAR(std::abs(found[1] - 1.0), 0, 1e-10) << mu_s;
  }
}

// The deformation of a spring that slides is slaved: as many multipliers less, against differences.
TEST(FrictionVariation, SpringSliderAgainstDifferences) {
  Model model({single_mass("block", 1, 1, 0.1)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 1, 0.8, 0.3),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts(
      {sliding_along_x(model, "block.head", "",
                       constant_with(1, std::make_shared<contact::SpringSlider>(5, 0.4, 0)))});
  Trajectory trajectory(model, contacts, settings_of("exact"));
  const auto image = [&](const Vector &from) {
    trajectory.start({.time = 0, .physical = from});
    trajectory.advance(9);
    return trajectory.motion_state().physical;
  };
  const Vector start = vector_of({0.3, 0.5, 0.01});
  trajectory.start({.time = 0, .physical = start});
  Changes changes(contacts);
  Variation variation(trajectory, Vector::Ones(3), 1e-11);
  variation.set_columns(Matrix::Identity(3, 3));
  Observers both({&variation, &changes});
  trajectory.advance(9, both);
  EXPECT_GE(changes.list.size(), 4u);
  const Matrix columns = variation.columns();
  for (Index j = 0; j < 3; ++j) {
    const Vector step = 1e-5 * Vector::Unit(3, j);
    const Vector difference = (image(start + step) - image(start - step)) / 2e-5;
    EXPECT_LT((difference - columns.col(j)).cwiseAbs().maxCoeff(), 1e-8) << j;
  }
}

// A particle on a tangential spring meets a side at an angle. Every normal law with every law of
// friction, at instants of stick, of slip and after the contact, against differences.
struct Oblique {
  std::shared_ptr<const contact::ContactLaw> normal;
  std::shared_ptr<const contact::TangentialLaw> tangential;
};

std::vector<Oblique> oblique_cases() {
  using namespace contact;
  const std::vector<std::shared_ptr<const ContactLaw>> normal = {
      std::make_shared<KelvinVoigt>(3e4, 90),
      std::make_shared<Hertz>(HertzConstants{.stiffness = 1e5}),
      HuntCrossley::with_dissipation({.stiffness = 1e5}, 0.2)};
  const StribeckConstants stribeck{
      .coefficient = 0.2, .static_coefficient = 0.4, .speed = 0.1, .damping_constant = 2};
  const std::vector<std::shared_ptr<const TangentialLaw>> tangential = {
      std::make_shared<Coulomb>(0.3, 0.35, 1),
      std::make_shared<SpringSlider>(2e5, 0.3, 0),
      std::make_shared<SpringSlider>(2e5, 0.3, 50),
      std::make_shared<PiecewiseLinear>(std::vector{0.0, 0.1}, std::vector{0.4, 0.2}, 0.4),
      std::make_shared<Stribeck>(stribeck),
      std::make_shared<LuGre>(LuGreConstants{
          .coefficient = stribeck, .stiffness = 5e3, .damping = 2, .viscous = 0.05})};
  std::vector<Oblique> cases;
  for (const auto &one : normal)
    for (const auto &other : tangential)
      cases.push_back({one, other});
  return cases;
}

TEST(FrictionVariation, ObliqueImpactsAgainstDifferences) {
  for (const Oblique &of : oblique_cases()) {
    const Model model({testing::particle("ball", 2, 4e5)});
    const ContactSet contacts({testing::oblique_contact(
        model, "ball.head", 0.1,
        std::make_shared<contact::FrictionalLaw>(of.normal, of.tangential))});
    Settings settings = settings_of("exact");
    settings.relative_tolerance = 1e-13;
    settings.absolute_tolerance = 0;
    Trajectory trajectory(model, contacts, settings);
    const Index size = trajectory.layout().physical_size();
    Vector start = Vector::Zero(size);
    start.head(4) << 0, 0.099, 0.25, 1;
    const Vector scale = (Vector(5) << 1e-3, 1e-2, 0.5, 1, 1e-4).finished().head(size);
    for (const double end : {0.0028, 0.021, 0.05}) {
      const auto image = [&](const Vector &from) {
        trajectory.start({.time = 0, .physical = from});
        trajectory.advance(end);
        return Vector(trajectory.motion_state().physical.cwiseQuotient(scale));
      };
      trajectory.start({.time = 0, .physical = start});
      Variation variation(trajectory, scale.cwiseInverse(), 1e-12);
      variation.set_columns(Matrix::Identity(size, size));
      trajectory.advance(end, variation);
      const Matrix columns =
          scale.cwiseInverse().asDiagonal() * variation.columns() * scale.asDiagonal();
      for (Index j = 0; j < 3; ++j) {
        const auto difference = testing::numerical_derivative(
            [&](double h) {
              return std::optional(image(start + h * scale[j] * Vector::Unit(size, j)));
            },
            1e-3, 4);
        EXPECT_LT((difference.value - columns.col(j)).cwiseAbs().maxCoeff(),
                  1e-7 * difference.value.cwiseAbs().maxCoeff())
            << of.normal->name() << ", " << of.tangential->name() << ", t = " << end << ", column "
            << j << ": " << difference.error << "\n"
            << difference.value.transpose() << "\n"
            << columns.col(j).transpose();
      }
    }
  }
}

} // namespace friction_variation_tests
} // namespace vibroimpact::motion
