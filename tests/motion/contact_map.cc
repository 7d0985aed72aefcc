// Deviations through contacts that are solved in one step: against differences of neighbouring
// contacts, and the determinants that are known.
#include "motion/variation/contact_map.h"

#include "support/power_force.h"

#include <gtest/gtest.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>

namespace vibroimpact::motion {
namespace {

// The penetration is the sum of the displacements of two oscillators, x = (a, a', b, b'); masses of
// 1 kg and 0.5 kg.
struct TwoOscillators {
  explicit TwoOscillators(double damping)
      : first(block(400, damping)), second(block(2500, 2 * damping)),
        flow({{.places = {0, 1}, .generator = first}, {.places = {2, 3}, .generator = second}},
             Vector{{0, -1, 0, -2}}),
        output(flow, Vector{{1, 0, 1, 0}}, 0, WholeContact::most_terms) {
    generator.setZero(4, 4);
    generator.topLeftCorner(2, 2) = first;
    generator.bottomRightCorner(2, 2) = second;
  }
  static Matrix block(double stiffness, double damping) {
    return (Matrix(2, 2) << 0, 1, -stiffness, -damping).finished();
  }
  Matrix free(double time) const { return Matrix(time * generator).exp(); }
  double penetration(const Vector &x) const { return x[0] + x[2]; }
  double rate(const Vector &x) const { return x[1] + x[3]; }

  Matrix first, second, generator;
  ForcedFlow flow;
  ForcedOutput output;
};

class ContactMaps : public ::testing::TestWithParam<std::pair<double, double>> {
protected:
  ContactMaps() : force_(GetParam().first < 2 ? 1e9 : 1e12, GetParam().first, GetParam().second) {}

  // From x near the touch to the state after `length`, through the contact.
  Vector after(const TwoOscillators &system, Vector x, double length) {
    double begin = 0;
    for (int i = 0; i < 4; ++i) {
      const double step = -system.penetration(x) / system.rate(x);
      x = system.free(step) * x;
      begin += step;
    }
    WholeContact contact = make(system);
    EXPECT_EQ(contact.solve(x.data(), 1), Refusal::none);
    const double duration = contact.duration();
    Vector end = system.free(duration) * x;
    const std::vector<double> moments = contact.moments(contact.tools().at_nodes);
    system.flow.add(duration, moments.data() + contact.nodes() * contact.terms(), contact.terms(),
                    end.data());
    nodes_ = contact.nodes();
    return system.free(length - begin - duration) * end;
  }
  WholeContact make(const TwoOscillators &system) const {
    const double n = GetParam().first;
    return {system.output, force_, n, n, n < 2 ? 1e-11 : 1e-10};
  }

  PowerForce force_;
  int nodes_ = 0;
  const Vector start_{{1e-3, 0.3, -1e-3, 0.2}};
};

TEST_P(ContactMaps, AgreeWithDifferences) {
  const TwoOscillators system(0.5);
  WholeContact contact = make(system);
  ASSERT_EQ(contact.solve(start_.data(), 1), Refusal::none);
  const double duration = contact.duration();
  const Matrix map =
      system.free(duration) +
      ContactMap(contact, system.output, start_.data()).forced(Matrix::Identity(4, 4));
  const double sizes[] = {1e-7, 1e-4, 1e-7, 1e-4};
  for (Index j = 0; j < 4; ++j) {
    const auto at = [&](double steps) {
      const Vector moved = after(system, start_ + steps * sizes[j] * Vector::Unit(4, j), duration);
      EXPECT_EQ(nodes_, contact.nodes());
      return moved;
    };
    const Vector slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * sizes[j]);
    EXPECT_LT((map.col(j) - slope).norm(), 1e-8 * slope.norm()) << "column " << j;
  }
}

// Liouville: volumes change by exp(T tr S + integral of what the contact damps), with 1 for an
// elastic contact of an undamped system.
TEST_P(ContactMaps, ChangeVolumesByTheDamping) {
  for (const double damping : {0.0, 0.5}) {
    const TwoOscillators system(damping);
    WholeContact contact = make(system);
    ASSERT_EQ(contact.solve(start_.data(), 1), Refusal::none);
    const double duration = contact.duration();
    const ContactMap passed(contact, system.output, start_.data());
    const Matrix map = system.free(duration) + passed.forced(Matrix::Identity(4, 4));
    const double expected = duration * system.generator.trace() + passed.divergence();
    // As exact as the polynomial of the force is; best for Hertz's exponent.
    const bool hertz = GetParam() == std::pair(1.5, 0.0);
    EXPECT_NEAR(std::log(map.determinant()), expected, hertz ? 1e-10 : 1e-8);
    EXPECT_EQ(passed.divergence() < 0, GetParam().second > 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ContactMaps,
                         ::testing::Values(std::pair(1.5, 0.0), std::pair(2.2, 0.0),
                                           std::pair(1.5, 0.5), std::pair(2.2, 0.3)));

} // namespace
} // namespace vibroimpact::motion
