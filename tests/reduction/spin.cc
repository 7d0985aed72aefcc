// Shafts that turn: projected gyroscopic matrices against closed forms.
#include "common/decompositions.h"
#include "reduction/beam_bodies.h"
#include "reduction/reduce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace spin_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;
using structure::BeamTheory;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double shaft_length = 0.6, shaft_diameter = 0.1;

/// Pinned in both planes, along x or in another direction, bending alone.
BeamDefinition pinned_shaft(int elements, BeamTheory theory) {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(shaft_length, 0, 0), elements};
  beam.section.kind = structure::SectionShape::Kind::circle;
  beam.section.diameter = shaft_diameter;
  beam.section.theory = theory;
  beam.material = {2e11, 0.3, 7800};
  beam.supports = {{"bending", {"all", {}}, {true, false, false, true, false, false}, {}},
                   {"left", {"start", {}}, {true, true, true, true, false, false}, {}},
                   {"right", {"end", {}}, {true, true, true, true, false, false}, {}}};
  beam.spin = structure::SpinAxis{};
  return beam;
}

/// Frequencies of whirl, rising [rad/s].
std::vector<double> whirl_frequencies(const ReducedBody &body, double speed) {
  const Index n = body.size();
  Matrix state = Matrix::Zero(2 * n, 2 * n);
  const Vector omega = body.omega();
  state.topRightCorner(n, n).diagonal() = omega;
  state.bottomLeftCorner(n, n).diagonal() = -omega;
  state.bottomRightCorner(n, n) = -speed * body.spin.gyroscopic;
  std::vector<double> frequencies;
  for (const std::complex<double> lambda : eigenvalues(state))
    if (lambda.imag() > 0)
      frequencies.push_back(lambda.imag());
  std::sort(frequencies.begin(), frequencies.end());
  return frequencies;
}

struct ShaftNumbers {
  double area, second_moment, bending, mass, shear;
};

ShaftNumbers numbers_of(const BeamDefinition &beam) {
  const double area = pi * shaft_diameter * shaft_diameter / 4;
  const double second_moment = pi * std::pow(shaft_diameter, 4) / 64;
  const double kappa = 6 * 1.3 / (7 + 6 * 0.3); // Cowper
  return {area, second_moment, beam.material.young_modulus * second_moment,
          beam.material.density * area, kappa * beam.material.young_modulus / 2.6 * area};
}

/// w^2 (1 + b) - 2 b W w - w0^2 = 0 with b = k^2 I / A, k = n pi / l; w < 0 is backward whirl.
double rayleigh_frequency(const BeamDefinition &beam, int number, double speed, int direction) {
  const ShaftNumbers s = numbers_of(beam);
  const double k = number * pi / shaft_length;
  const double b = k * k * s.second_moment / s.area;
  const double rest = s.bending / s.mass * std::pow(k, 4);
  return (direction * b * speed + std::sqrt(b * b * speed * speed + (1 + b) * rest)) / (1 + b);
}

/// The lowest root: (G k^2 - m w^2)(E k^2 + G - J w^2 + 2 J W w) = G^2 k^2, by bisection.
double timoshenko_frequency(const BeamDefinition &beam, int number, double speed, int direction) {
  const ShaftNumbers s = numbers_of(beam);
  const double k = number * pi / shaft_length;
  const double inertia = beam.material.density * s.second_moment;
  const auto determinant = [&](double w) {
    return (s.shear * k * k - s.mass * w * w) * (s.bending * k * k + s.shear - inertia * w * w +
                                                 2 * inertia * speed * direction * w) -
           s.shear * s.shear * k * k;
  };
  double low = 0, high = rayleigh_frequency(beam, number, speed, direction);
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (determinant(middle) > 0 ? low : high) = middle;
  }
  return low;
}

/// Errors of the lowest whirls of the first two half-waves.
std::vector<double> errors(int elements, BeamTheory theory, double speed) {
  const BeamDefinition beam = pinned_shaft(elements, theory);
  const ReducedBody body = reduced(beam, 4 * elements);
  const std::vector<double> found = whirl_frequencies(body, speed);
  std::vector<double> list;
  for (const int number : {1, 2})
    for (const int direction : {-1, 1}) {
      const double exact = theory == BeamTheory::rayleigh
                               ? rayleigh_frequency(beam, number, speed, direction)
                               : timoshenko_frequency(beam, number, speed, direction);
      const auto nearest = std::min_element(found.begin(), found.end(), [&](double a, double b) {
        return std::abs(a - exact) < std::abs(b - exact);
      });
      list.push_back(std::abs(*nearest / exact - 1));
    }
  return list;
}

} // namespace

TEST(Spin, RayleighShaftHasTheFrequenciesOfTheQuadratic) {
  constexpr double speed = 9000;
  for (const double error : errors(24, BeamTheory::rayleigh, speed))
    EXPECT_LT(error, 4e-6);
}

TEST(Spin, WhirlConvergesWithOrderFour) {
  constexpr double speed = 9000;
  for (const BeamTheory theory : {BeamTheory::rayleigh, BeamTheory::timoshenko}) {
    const std::vector<double> coarse = errors(6, theory, speed);
    const std::vector<double> fine = errors(12, theory, speed);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      EXPECT_GT(std::log2(coarse[i] / fine[i]), 3.7) << i;
      EXPECT_LT(std::log2(coarse[i] / fine[i]), 4.5) << i;
    }
  }
}

// The direction of the line and of its elements does not matter, that of the axis does.
TEST(Spin, AxisGivesTheSign) {
  BeamDefinition beam = pinned_shaft(6, BeamTheory::rayleigh);
  const Matrix along = reduced(beam, 4).spin.gyroscopic;
  beam.spin->direction = -Vector3::UnitX();
  EXPECT_LT((reduced(beam, 4).spin.gyroscopic + along).norm(), 1e-12 * along.norm());
  BeamDefinition turned = pinned_shaft(6, BeamTheory::rayleigh);
  std::swap(turned.line.start, turned.line.end);
  const auto expected = whirl_frequencies(reduced(pinned_shaft(6, BeamTheory::rayleigh), 4), 500);
  const auto found = whirl_frequencies(reduced(turned, 4), 500);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-9 * expected[i]);
}

TEST(Spin, DiscAddsItsPolarInertia) {
  BeamDefinition beam = pinned_shaft(6, BeamTheory::rayleigh);
  beam.material.density = 0;
  beam.points.push_back({.name = "disc",
                         .at = {"", Vector3(0.2, 0, 0)},
                         .mass = 2,
                         .rotary_inertia = Vector3(0.05, 0.03, 0.03)});
  const ReducedBody body = reduced(beam, 4);
  const Matrix rows = body.point("disc").rows;
  const Matrix expected =
      0.05 * (rows.row(4).transpose() * rows.row(5) - rows.row(5).transpose() * rows.row(4));
  EXPECT_LT((body.spin.gyroscopic - expected).norm(), 1e-13 * expected.norm());
  EXPECT_LT((body.spin.turning + body.spin.turning.transpose()).norm(), 1e-16);
}

namespace {

/// (1 + b) l^2 - 2 i b W l + w0^2 (1 + tau (l - i W)) = 0 of forward whirl with internal damping.
std::complex<double> damped_whirl(const BeamDefinition &beam, double speed) {
  const ShaftNumbers s = numbers_of(beam);
  const double k = pi / shaft_length;
  const double b = k * k * s.second_moment / s.area;
  const double rest = s.bending / s.mass * std::pow(k, 4);
  const double tau = beam.spin->internal_damping;
  const std::complex<double> linear(tau * rest, -2 * b * speed);
  const std::complex<double> constant(rest, -tau * rest * speed);
  const std::complex<double> root = std::sqrt(linear * linear - 4 * (1 + b) * constant);
  return (-linear + (root.imag() > 0 ? root : -root)) / (2 * (1 + b));
}

double error_of_damped_whirl(int elements, double speed) {
  BeamDefinition beam = pinned_shaft(elements, BeamTheory::rayleigh);
  beam.spin->internal_damping = 2e-5;
  const ReducedBody body = reduced(beam, 4 * elements);
  const Index n = body.size();
  Matrix state = Matrix::Zero(2 * n, 2 * n);
  state.topRightCorner(n, n).diagonal() = body.omega();
  state.bottomLeftCorner(n, n) =
      -speed * body.spin.circulatory * body.omega().cwiseInverse().asDiagonal();
  state.bottomLeftCorner(n, n).diagonal() -= body.omega();
  state.bottomRightCorner(n, n) = -speed * body.spin.gyroscopic - body.damping;
  const std::complex<double> expected = damped_whirl(beam, speed);
  double least = std::abs(expected);
  for (const std::complex<double> lambda : eigenvalues(state))
    least = std::min(least, std::abs(lambda - expected));
  return least / std::abs(expected);
}

} // namespace

// Below and above its critical speed, W^2 = w0^2 / (1 - b), at which the whirl is synchronous and
// nothing damps it.
TEST(Spin, InternalDampingHasTheEigenvaluesOfTheQuadratic) {
  const BeamDefinition beam = pinned_shaft(4, BeamTheory::rayleigh);
  const double critical = rayleigh_frequency(beam, 1, 0, 1);
  for (const double speed : {0.0, 0.5 * critical, 3 * critical}) {
    const double coarse = error_of_damped_whirl(6, speed);
    const double fine = error_of_damped_whirl(12, speed);
    EXPECT_LT(fine, 1e-4);
    EXPECT_GT(std::log2(coarse / fine), 3.7) << speed;
    EXPECT_LT(std::log2(coarse / fine), 4.5) << speed;
  }
  BeamDefinition damped = beam;
  damped.spin->internal_damping = 2e-5;
  EXPECT_LT(damped_whirl(damped, 0.5 * critical).real(), 0);
  EXPECT_GT(damped_whirl(damped, 3 * critical).real(), 0);
}

// All of the elasticity turns: the damping is that of the strain energy.
TEST(Spin, InternalDampingGoesByTheStiffnessOfWhatTurns) {
  BeamDefinition beam = pinned_shaft(6, BeamTheory::timoshenko);
  const Matrix without = reduced(beam, 6).damping;
  EXPECT_EQ(reduced(beam, 6).spin.circulatory.size(), 0);
  beam.spin->internal_damping = 3e-5;
  const ReducedBody body = reduced(beam, 6);
  const Matrix expected = 3e-5 * Matrix(body.stiffness.asDiagonal());
  EXPECT_LT((body.damping - without - expected).norm(), 1e-9 * expected.norm());
  EXPECT_LT((body.spin.circulatory + body.spin.circulatory.transpose()).norm(),
            1e-15 * body.spin.circulatory.norm());
}

// A hinge about y alone bends differently as it turns.
TEST(Spin, InternalDampingNeedsHingesInBothDirections) {
  BeamDefinition beam = pinned_shaft(6, BeamTheory::rayleigh);
  beam.supports = {{"left", {"start", {}}, {true, true, true, true, true, true}, {}},
                   {"right", {"end", {}}, {true, true, true, true, true, true}, {}}};
  structure::Member member{.name = "half", .between = {{0, shaft_length / 2}}};
  member.section = beam.section;
  member.material = beam.material;
  beam.members.push_back(member);
  structure::Hinge hinge{
      .name = "joint", .member = "half", .at = {"", Vector3(shaft_length / 2, 0, 0)}};
  hinge.free[4] = true;
  beam.hinges.push_back(hinge);
  EXPECT_NO_THROW(reduced(beam, 2));
  beam.spin->internal_damping = 1e-5;
  EXPECT_THROW(reduced(beam, 2), structure::DefinitionError);
  beam.hinges[0].free[5] = true;
  EXPECT_NO_THROW(reduced(beam, 2));
}

TEST(Spin, RefusesWhatCannotTurn) {
  BeamDefinition beam = pinned_shaft(4, BeamTheory::euler_bernoulli);
  EXPECT_THROW(reduced(beam, 2), structure::DefinitionError);
  beam = pinned_shaft(4, BeamTheory::rayleigh);
  beam.spin->direction = Vector3::UnitY();
  EXPECT_THROW(reduced(beam, 2), structure::DefinitionError);
  beam = pinned_shaft(4, BeamTheory::rayleigh);
  beam.section.kind = structure::SectionShape::Kind::rectangle;
  beam.section.width = 0.1;
  beam.section.thickness = 0.05;
  EXPECT_THROW(reduced(beam, 2), structure::DefinitionError);
  beam = pinned_shaft(4, BeamTheory::rayleigh);
  beam.points.push_back(
      {.name = "disc", .at = {"end", {}}, .mass = 2, .rotary_inertia = Vector3(0.05, 0.03, 0.02)});
  EXPECT_THROW(reduced(beam, 2), structure::DefinitionError);
}

} // namespace spin_tests
