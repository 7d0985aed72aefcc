// Deviations through contacts that are solved in one step: against differences of neighbouring
// contacts, and the determinants that are known.
#include "motion/variation/contact_map.h"

#include "common/decompositions.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/tsuji.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace contact_map_tests {

// The penetration is the sum of the displacements of two oscillators, x = (a, a', b, b'); masses of
// 1 kg and 0.5 kg.
struct TwoOscillators {
  explicit TwoOscillators(double damping)
      : first(block(400, damping)), second(block(2500, 2 * damping)),
        flow({{.places = {0, 1}, .generator = first}, {.places = {2, 3}, .generator = second}},
             Vector{{0, -1, 0, -2}}),
        output(flow, Vector{{1, 0, 1, 0}}, 0, ContactEpisode::most_terms) {
    generator.setZero(4, 4);
    generator.topLeftCorner(2, 2) = first;
    generator.bottomRightCorner(2, 2) = second;
  }
  static Matrix block(double stiffness, double damping) {
    return (Matrix(2, 2) << 0, 1, -stiffness, -damping).finished();
  }
  Matrix free(double time) const { return exponential(time * generator); }
  double penetration(const Vector &x) const { return x[0] + x[2]; }
  double rate(const Vector &x) const { return x[1] + x[3]; }

  Matrix first, second, generator;
  ForcedFlow flow;
  ForcedOutput output;
};

struct PassedContact {
  std::shared_ptr<const contact::ContactLaw> law;
  double tolerance;
};

class ContactMaps : public ::testing::TestWithParam<PassedContact> {
protected:
  ContactMaps() : force_(*GetParam().law, 1) {}

  // From x near the touch to the state after `length`, through the contact.
  Vector after(const TwoOscillators &system, Vector x, double length) {
    double begin = 0;
    for (int i = 0; i < 4; ++i) {
      const double step = -system.penetration(x) / system.rate(x);
      x = system.free(step) * x;
      begin += step;
    }
    ContactEpisode contact = make(system);
    EXPECT_EQ(contact.solve(x.data(), 1), Refusal::none);
    const double duration = contact.duration();
    Vector end = system.free(duration) * x;
    const std::vector<double> moments = contact.moments(contact.tools().at_nodes);
    system.flow.add(duration, moments.data() + contact.nodes() * contact.terms(), contact.terms(),
                    end.data());
    nodes_ = contact.nodes();
    return system.free(length - begin - duration) * end;
  }
  ContactEpisode make(const TwoOscillators &system) const {
    const contact::ContactLaw &law = *GetParam().law;
    const contact::ForcePulse course = *law.force_pulse(1);
    const contact::ForcePulse::End &end = course.ends.front();
    const contact::AffineForm &form = law.modes()[1].guards[end.guard].indicator;
    ContactEpisode made(system.output, force_, course.begin, end.edge, GetParam().tolerance);
    made.set_end({form.constant, -form.gap, -form.gap_rate});
    return made;
  }

  LawForce force_;
  int nodes_ = 0;
  const Vector start_{{1e-3, 0.3, -1e-3, 0.2}};
};

TEST_P(ContactMaps, AgreeWithDifferences) {
  const TwoOscillators system(0.5);
  ContactEpisode contact = make(system);
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
    ContactEpisode contact = make(system);
    ASSERT_EQ(contact.solve(start_.data(), 1), Refusal::none);
    const double duration = contact.duration();
    const ContactMap passed(contact, system.output, start_.data());
    const Matrix map = system.free(duration) + passed.forced(Matrix::Identity(4, 4));
    const double expected = duration * system.generator.trace() + passed.divergence();
    // As exact as the polynomial of the force is; best for Hertz's exponent.
    const bool hertz = GetParam().tolerance < 1e-10 && passed.divergence() == 0;
    EXPECT_NEAR(std::log(determinant(map)), expected, hertz ? 1e-10 : 1e-8);
    EXPECT_EQ(passed.divergence() < 0, GetParam().law->name() != "hertz");
  }
}

std::vector<PassedContact> passed_contacts() {
  using namespace contact;
  const HertzConstants half{.stiffness = 1e9}, higher{.stiffness = 1e12, .exponent = 2.2};
  return {{std::make_shared<Hertz>(half), 1e-11},
          {std::make_shared<Hertz>(higher), 1e-10},
          {HuntCrossley::with_dissipation(half, 0.5), 1e-11},
          {HuntCrossley::with_dissipation(higher, 0.3), 1e-10},
          {std::make_shared<KuwabaraKono>(1e9, 1e-4), 1e-11},
          {std::make_shared<Tsuji>(1e9, 1e4), 1e-9}};
}

INSTANTIATE_TEST_SUITE_P(Laws, ContactMaps, ::testing::ValuesIn(passed_contacts()));

} // namespace contact_map_tests
} // namespace vibroimpact::motion
