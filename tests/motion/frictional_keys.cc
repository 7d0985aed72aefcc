// Derivatives by keys, and multipliers, of motions with contacts in circular gaps, and of plane
// ones with friction and a nonlinear law: differences of the motions, and closed forms.
#include "common/decompositions.h"
#include "common/error.h"
#include "contact/friction/spring_slider.h"
#include "contact/friction/viscous.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "motion/variation/linearised_motion.h"
#include "support/circular_contacts.h"
#include "support/key_families.h"
#include "support/motion_derivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>

namespace vibroimpact::motion {
namespace frictional_keys_tests {

using contact::CircularGap;
using contact::ContactSet;
using contact::Coulomb;
using model::Given;
using model::Harmonic;
using model::Model;
using testing::isotropic;
using testing::Parts;
using testing::ring_about_z;
using testing::tangent_by_key;
using testing::unbalanced_rotor;
using testing::vector_of;
constexpr double pi = std::numbers::pi;

Settings accurate() {
  Settings settings = testing::settings_of("exact");
  settings.relative_tolerance = 1e-12;
  settings.absolute_tolerance = 0;
  return settings;
}

/// A ball in a ring whose surface moves, driven along x: each number by its name.
struct Ball {
  double mass = 2, spring = 400, clearance = 0.013, centre = 0.002, stiffness = 3e4, speed = 5,
         load = 3, frequency = 20, damping = 90, friction = 0.2;
  bool around = false; ///< another disc beside it, at the distance of the radii and the clearance

  Parts parts(const std::function<std::shared_ptr<const contact::ContactLaw>(const Ball &)> &normal,
              const std::function<std::shared_ptr<const contact::TangentialLaw>(const Ball &)>
                  &tangential) const {
    Model model({isotropic("ball", mass, spring, 0.5)});
    model.add_force("push", std::make_shared<Harmonic>(Given::displacement, load, frequency, 0.4),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    ContactSet contacts({ring_about_z(
        model, "ball.head", "", clearance, normal(*this), tangential(*this), speed,
        around ? CircularGap::Kind::beside : CircularGap::Kind::inside,
        around ? contact::AcrossAxis{clearance + centre, 0} : contact::AcrossAxis{centre, 0})});
    return {std::move(model), std::move(contacts)};
  }
};

using NormalLaw = std::function<std::shared_ptr<const contact::ContactLaw>(const Ball &)>;
using Friction = std::function<std::shared_ptr<const contact::TangentialLaw>(const Ball &)>;

std::vector<NormalLaw> normal_laws() {
  return {[](const Ball &of) { return std::make_shared<contact::LinearPenalty>(of.stiffness); },
          [](const Ball &of) {
            return std::make_shared<contact::KelvinVoigt>(of.stiffness, of.damping);
          },
          [](const Ball &of) {
            return std::make_shared<contact::Hertz>(
                contact::HertzConstants{.stiffness = 3 * of.stiffness});
          }};
}

std::vector<Friction> frictions() {
  return {[](const Ball &) { return nullptr; },
          [](const Ball &of) { return std::make_shared<Coulomb>(of.friction, of.friction, 3); },
          [](const Ball &of) { return std::make_shared<contact::Viscous>(100 * of.friction); },
          [](const Ball &of) {
            return std::make_shared<contact::SpringSlider>(of.stiffness, of.friction, of.damping);
          }};
}

/// Compares the derivatives of a motion of this family, through contacts, with differences.
void agree_with_differences(const std::function<Parts(double)> &make, double value,
                            const std::string &what) {
  const Parts parts = make(value);
  Trajectory trajectory(parts.model, parts.contacts, accurate());
  const Vector internal = parts.contacts.initial_internal();
  Vector from(4 + internal.size()), sizes(from.size());
  from << 0.003, -0.004, 0.3, 0.45, internal;
  sizes << 1e-3, 1e-3, 0.1, 0.1, Vector::Constant(internal.size(), 1e-4);
  const double end = 0.12;
  KeyTangent tangent = tangent_by_key(make, value, parts);
  Lineariser linearise(trajectory, {.scale = sizes.cwiseInverse(), .tolerance = 1e-11});
  const LinearisedMotion motion = linearise({.time = 0, .physical = from}, end, {&tangent});
  EXPECT_GE(motion.events, 1) << what;
  const auto differences = testing::numerical_derivative(
      [&](double by) {
        const Parts near = make(value + by);
        Trajectory other(near.model, near.contacts, accurate());
        other.start({.time = 0, .physical = from});
        other.advance(end);
        return std::optional<Vector>(other.motion_state().physical.cwiseQuotient(sizes));
      },
      1e-3 * value);
  const Vector by_key = motion.by_key.col(0).cwiseQuotient(sizes);
  // Where nothing depends on the key: errors of 1e-11 of the motion over steps of 1e-3 of the key,
  // in a formula whose weights add up to ten.
  const double rounding = 1e-7 / value;
  EXPECT_LT((by_key - differences.value).cwiseAbs().maxCoeff(),
            std::max(1e-6 * differences.value.cwiseAbs().maxCoeff(), rounding))
      << what << ": " << differences.error << "\n"
      << differences.value.transpose() << "\n"
      << by_key.transpose();
}

const std::vector<double Ball::*> all_keys = {
    &Ball::mass, &Ball::spring,    &Ball::clearance, &Ball::centre,  &Ball::speed,
    &Ball::load, &Ball::stiffness, &Ball::frequency, &Ball::damping, &Ball::friction};

// By every number that model and contact have.
TEST(FrictionalKeys, OfCircularGapsAgainstDifferences) {
  for (const bool around : {false, true})
    for (std::size_t n = 0; n < normal_laws().size(); ++n)
      for (std::size_t f = 0; f < frictions().size(); ++f)
        for (std::size_t k = 0; k < all_keys.size(); ++k) {
          const Ball ball{.around = around};
          agree_with_differences(
              [&](double value) {
                Ball near = ball;
                near.*all_keys[k] = value;
                return near.parts(normal_laws()[n], frictions()[f]);
              },
              ball.*all_keys[k],
              "normal " + std::to_string(n) + ", friction " + std::to_string(f) + ", key " +
                  std::to_string(k) + (around ? ", beside" : ", inside"));
        }
}

// A wall along x at y = 0.013 whose surface moves.
TEST(FrictionalKeys, OfPlaneContactsWithANonlinearLaw) {
  const NormalLaw hertz = normal_laws().back();
  for (std::size_t f = 1; f < frictions().size(); ++f)
    for (std::size_t k = 0; k < all_keys.size(); ++k) {
      if (all_keys[k] == &Ball::centre)
        continue;
      agree_with_differences(
          [&](double value) {
            Ball near;
            near.*all_keys[k] = value;
            Parts parts = near.parts(hertz, frictions()[0]);
            contact::ContactPair wall = testing::oblique_contact(
                parts.model, "ball.head", near.clearance,
                std::make_shared<contact::FrictionalLaw>(hertz(near), frictions()[f](near)));
            wall.tangential[0].surface_speed = near.speed;
            parts.contacts = ContactSet({wall});
            return parts;
          },
          Ball{}.*all_keys[k], "friction " + std::to_string(f) + ", key " + std::to_string(k));
    }
}

/// A rotor with an unbalance that rubs in step with it, m = k = 1.
struct Rub {
  double unbalance = 0.05, damping = 0.1, friction = 0.1, ring = 0.5, clearance = 0.1;
  double speed = 1.1;

  // (1 - W^2) r + N + i (c W r + mu N), whose size the unbalance e W^2 has
  std::complex<double> load(double radius) const {
    const double force = ring * (radius - clearance);
    return {(1 - speed * speed) * radius + force, damping * speed * radius + friction * force};
  }
  double radius() const {
    double low = clearance, high = 1;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (std::abs(load(middle)) > unbalance * speed * speed ? high : low) = middle;
    }
    return low;
  }
  Vector start() const {
    const double r = radius();
    const std::complex<double> place = std::polar(r, -std::arg(load(r)));
    const std::complex<double> rate = std::complex<double>(0, speed) * place;
    return vector_of({place.real(), place.imag(), rate.real(), rate.imag()});
  }
  Parts parts() const {
    Model model = unbalanced_rotor(damping, unbalance, speed);
    ContactSet contacts({ring_about_z(model, "rotor.head", "", clearance,
                                      std::make_shared<contact::LinearPenalty>(ring),
                                      std::make_shared<Coulomb>(friction, friction))});
    return {std::move(model), std::move(contacts)};
  }
};

// x' = (1 - P_x)^-1 P_p against the derivative of the closed form.
TEST(FrictionalKeys, SynchronousRubAlongKeys) {
  for (double Rub::*const key :
       {&Rub::unbalance, &Rub::damping, &Rub::friction, &Rub::ring, &Rub::clearance}) {
    const auto of = [&](double value) {
      Rub rub;
      rub.*key = value;
      return rub;
    };
    const Rub rub;
    const Parts parts = rub.parts();
    Trajectory trajectory(parts.model, parts.contacts, accurate());
    KeyTangent tangent =
        tangent_by_key([&](double value) { return of(value).parts(); }, rub.*key, parts);
    Lineariser linearise(trajectory, {.scale = Vector::Constant(4, 10), .tolerance = 1e-12});
    const LinearisedMotion motion =
        linearise({.time = 0, .physical = rub.start()}, 2 * pi / rub.speed, {&tangent});
    EXPECT_EQ(motion.events, 0);
    const Vector along =
        solve_fully_pivoted(Matrix::Identity(4, 4) - motion.by_state, motion.by_key.col(0));
    const auto expected = testing::numerical_derivative(
        [&](double by) { return std::optional<Vector>(of(rub.*key + by).start()); },
        1e-3 * rub.*key);
    EXPECT_LT((along - expected.value).norm(), 1e-8 * expected.value.norm()) << rub.*key;
  }
}

// Dry backward whirl with q = (r + a + i b) exp(-i W t), N = k_s (r - c) = c_d W r / mu:
//   a'' = -2 W b' - c_d a' + (W^2 - k - k_s) a,   b'' = 2 W a' - c_d b' + (c_d W - mu k_s) a
// of which one solution grows: the whirl is a saddle.
TEST(FrictionalKeys, MultipliersOfDryBackwardWhirl) {
  const double damping = 0.1, mu = 0.2, ring = 30, clearance = 0.1;
  const double whirl = (damping / mu + std::sqrt(damping * damping / (mu * mu) + 4)) / 2;
  const double radius = ring * clearance / (ring - damping * whirl / mu);
  const double period = 2 * pi / whirl;
  Model model({isotropic("disc", 1, 1, damping)});
  const ContactSet contacts({ring_about_z(model, "disc.head", "", clearance,
                                          std::make_shared<contact::LinearPenalty>(ring),
                                          std::make_shared<Coulomb>(mu, mu), -50)});
  Trajectory trajectory(model, contacts, accurate());
  Lineariser linearise(trajectory, {.scale = Vector::Constant(4, 10), .tolerance = 1e-12});
  const LinearisedMotion motion =
      linearise({.time = 0, .physical = vector_of({radius, 0, 0, -whirl * radius})}, period);
  Matrix generator = Matrix::Zero(4, 4); // of a, b, a', b'
  generator(0, 2) = generator(1, 3) = 1;
  generator.row(2) << whirl * whirl - 1 - ring, 0, -damping, -2 * whirl;
  generator.row(3) << damping * whirl - mu * ring, 0, 2 * whirl, -damping;
  Matrix to_place = Matrix::Identity(4, 4); // x' = a' + W b, y' = b' - W a
  to_place(2, 1) = whirl;
  to_place(3, 0) = -whirl;
  const Matrix expected = to_place * exponential(generator * period) * inverse(to_place);
  EXPECT_LT((motion.by_state - expected).norm(), 1e-8 * expected.norm());
  const double largest = eigenvalues(expected).cwiseAbs().maxCoeff();
  EXPECT_GT(largest, 1.5);
  EXPECT_NEAR(eigenvalues(motion.by_state).cwiseAbs().maxCoeff(), largest, 1e-8 * largest);
}

} // namespace frictional_keys_tests
} // namespace vibroimpact::motion
