// One impact with friction, and several at one instant, against closed forms and what must hold for
// any of them.
#include "contact/frictional_impulses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vibroimpact::contact {
namespace frictional_impact_tests {

constexpr RestitutionHypothesis all_hypotheses[] = {RestitutionHypothesis::energetic,
                                                    RestitutionHypothesis::newton,
                                                    RestitutionHypothesis::poisson};

double energy_change(const PointImpact &impact, const PointImpulse &found) {
  return 0.5 * (found.impulse[0] * (impact.gap_rate + found.after[0]) +
                found.impulse[1] * (impact.slip_rate + found.after[1]));
}

// A sphere, e .8, mu .3, approach speed 1: it sticks below the speed (7/2) mu (1 + e) = 1.89 at the
// contact, whose mobility along the surface is 7/2 of that across it (Walton 1993).
TEST(FrictionalImpactTest, SphereSticksOrSlides) {
  for (const RestitutionHypothesis hypothesis : all_hypotheses)
    for (const double u : {0.5, 1.5, 2.5}) {
      const PointImpulse found = impulse_at_point({.normal = 1,
                                                   .tangential = 3.5,
                                                   .gap_rate = -1,
                                                   .slip_rate = u,
                                                   .friction = 0.3,
                                                   .restitution = 0.8,
                                                   .hypothesis = hypothesis});
      EXPECT_NEAR(found.impulse[0], 1.8, 1e-15);
      EXPECT_NEAR(found.after[0], 0.8, 1e-15);
      EXPECT_NEAR(found.after[1], u < 1.89 ? 0 : 0.61, 1e-15);
      EXPECT_NEAR(found.impulse[1], u < 1.89 ? -u / 3.5 : -0.54, 1e-15);
    }
}

// A rod of length and mass one that falls on its end, as published with a program of another kind;
// its slip turns back within the impact. theta: from the vertical.
PointImpact falling_rod(RestitutionHypothesis hypothesis) {
  const double theta = 0.791425572, s = std::sin(theta), c = std::cos(theta);
  return {.normal = 1 + 3 * s * s,
          .coupling = -3 * s * c,
          .tangential = 1 + 3 * c * c,
          .gap_rate = -0.467173094,
          .slip_rate = 0.464858403,
          .friction = 0.01,
          .restitution = 1,
          .hypothesis = hypothesis};
}

// The slip turns in the restitution, so that the impulse of the compression is that without a turn.
TEST(FrictionalImpactTest, RodThatFallsOnItsEnd) {
  const double impulses[] = {0.368989543, 0.369624341, 0.368857648};
  for (int k = 0; k < 3; ++k) {
    const PointImpact impact = falling_rod(all_hypotheses[k]);
    const PointImpulse found = impulse_at_point(impact);
    EXPECT_NEAR(found.impulse[0], impulses[k], 1e-9);
    EXPECT_LT(found.after[1], 0);
    EXPECT_LT(std::abs(found.impulse[1]), 0.01 * found.impulse[0]);
  }
}

// The same by the direction of slip after the impact, as several contacts have it: the energy
// grows.
TEST(FrictionalImpactTest, RodWithTheDirectionOfSlipAfterTheImpact) {
  const PointImpact rod = falling_rod(RestitutionHypothesis::newton);
  Matrix matrix(2, 2);
  matrix << rod.normal, rod.coupling, rod.coupling, rod.tangential;
  Vector start(2);
  start << 2 * rod.gap_rate, rod.slip_rate;
  const FrictionalSolution found =
      solve_frictional(matrix, start, {{.coefficient = 0.01, .at_rest = 0.01}});
  EXPECT_NEAR(found.impulses[0], 0.373278167, 1e-9);
  EXPECT_NEAR(found.impulses[1], 0.00373278167, 1e-11);
  const Vector sum =
      Vector(start + matrix * found.impulses) + Vector(Eigen::Vector2d(0, rod.slip_rate));
  EXPECT_NEAR(0.5 * found.impulses.dot(sum), 7e-4, 1e-4);
}

PointImpact random_impact(std::mt19937_64 &generator) {
  std::uniform_real_distribution<double> any(-1, 1), part(0, 1);
  PointImpact impact{.normal = std::exp(2 * any(generator)),
                     .tangential = std::exp(2 * any(generator)),
                     .gap_rate = -part(generator),
                     .slip_rate = 3 * any(generator),
                     .friction = 1.5 * part(generator),
                     .restitution = part(generator)};
  impact.coupling = any(generator) * std::sqrt(impact.normal * impact.tangential) * (1 - 1e-6);
  return impact;
}

void judge_random_impacts(int count) {
  std::mt19937_64 generator(7); // NOLINT(cert-msc51-cpp): the same in every run
  long grown = 0;
  for (int i = 0; i < count; ++i) {
    PointImpact impact = random_impact(generator);
    for (const RestitutionHypothesis hypothesis : all_hypotheses) {
      impact.hypothesis = hypothesis;
      const PointImpulse found = impulse_at_point(impact);
      const double size = std::abs(found.impulse[0] * impact.gap_rate) +
                          std::abs(found.impulse[1] * impact.slip_rate);
      const double change = energy_change(impact, found);
      ASSERT_GE(found.impulse[0], 0);
      ASSERT_GE(found.after[0], 0);
      ASSERT_LE(std::abs(found.impulse[1]), impact.friction * found.impulse[0] * (1 + 1e-12));
      // What friction takes is mu times what rubs.
      ASSERT_GE(found.rubbing, 0);
      if (hypothesis == RestitutionHypothesis::newton) {
        ASSERT_NEAR(found.after[0], -impact.restitution * impact.gap_rate, 1e-12);
        grown += change > 1e-12 * size ? 1 : 0;
      } else {
        ASSERT_LE(change, 1e-12 * size) << i;
      }
      const Eigen::Vector2d after(impact.gap_rate + impact.normal * found.impulse[0] +
                                      impact.coupling * found.impulse[1],
                                  impact.slip_rate + impact.coupling * found.impulse[0] +
                                      impact.tangential * found.impulse[1]);
      ASSERT_LT((after - found.after).norm(), 1e-12 * (1 + size)) << i;
    }
  }
  EXPECT_GT(grown, count / 100); // of Newton's alone, where the slip turns or stops
}

TEST(FrictionalImpactTest, EnergyGrowsByNewtonsHypothesisAlone) { judge_random_impacts(20000); }
TEST(FrictionalImpactMillion, EnergyGrowsByNewtonsHypothesisAlone) {
  judge_random_impacts(1000000);
}

// Slip that presses the sides together ends by itself.
TEST(FrictionalImpactTest, SlipThatWedgesTheSidesComesToStick) {
  const PointImpulse found = impulse_at_point({.normal = 1,
                                               .coupling = 1.2,
                                               .tangential = 2,
                                               .gap_rate = -0.1,
                                               .slip_rate = 1,
                                               .friction = 1,
                                               .restitution = 0.5});
  EXPECT_EQ(found.after[1], 0);
  EXPECT_GT(found.after[0], 0.05); // the slip has driven it in
}

// On a rail one velocity is all there is: it stops with nothing to come back by.
TEST(FrictionalImpactTest, OnARailThatHoldsThereIsNoWayBack) {
  const PointImpulse found = impulse_at_point({.normal = 1,
                                               .coupling = 1,
                                               .tangential = 1,
                                               .gap_rate = -1,
                                               .slip_rate = -1,
                                               .friction = 1.5,
                                               .restitution = 1});
  EXPECT_EQ(found.after, Eigen::Vector2d(0, 0));
  EXPECT_NEAR(found.impulse.sum(), 1, 1e-15);
}

TEST(FrictionalImpactTest, DerivativesAreThoseOfDifferences) {
  std::mt19937_64 generator(11); // NOLINT(cert-msc51-cpp)
  for (int i = 0; i < 300; ++i) {
    PointImpact impact = random_impact(generator);
    impact.hypothesis = all_hypotheses[i % 3];
    impact.gap_rate -= 0.1;
    const PointImpulse found = impulse_at_point(impact);
    constexpr double step = 1e-6;
    Eigen::Matrix2d differences;
    for (int k = 0; k < 2; ++k) {
      PointImpact above = impact, below = impact;
      (k == 0 ? above.gap_rate : above.slip_rate) += step;
      (k == 0 ? below.gap_rate : below.slip_rate) -= step;
      differences.col(k) =
          (impulse_at_point(above).impulse - impulse_at_point(below).impulse) / (2 * step);
    }
    EXPECT_LT((differences - found.by_rates).norm(), 1e-5 * found.by_rates.norm()) << i;
  }
}

// Several contacts of random bodies: G = W M^-1 W^T with more or fewer coordinates than rows.
FrictionalImpact random_contacts(std::mt19937_64 &generator, Index count) {
  std::uniform_real_distribution<double> any(-1, 1), part(0, 1);
  const auto coordinates = 1 + static_cast<Index>(3 * static_cast<double>(count) * part(generator));
  const auto random = [&](Index rows, Index columns) {
    return Matrix(Matrix::NullaryExpr(rows, columns, [&] { return any(generator); }));
  };
  Matrix w = random(2 * count, coordinates);
  FrictionalImpact impact;
  Vector speeds = random(coordinates, 1);
  impact.restitution = Vector::Zero(count);
  for (Index c = 0; c < count; ++c) {
    const bool frictionless = part(generator) < 0.2;
    if (frictionless)
      w.row(2 * c + 1).setZero();
    const double mu = frictionless ? 0 : 0.5 * part(generator) + 0.01;
    impact.contacts.push_back({.coefficient = mu, .at_rest = mu});
    impact.hypotheses.push_back(RestitutionHypothesis::energetic);
  }
  for (Index c = 0; c < count; ++c) // all approach
    if (w.row(2 * c).dot(speeds) > 0)
      w.row(2 * c) *= -1;
  impact.matrix = w * w.transpose();
  impact.rates = w * speeds;
  for (Index c = 0; c < count; ++c)
    impact.restitution[c] = part(generator) < 0.3 ? 0 : part(generator);
  return impact;
}

void judge_random_contacts(int count_of_each) {
  std::mt19937_64 generator(5); // NOLINT(cert-msc51-cpp)
  long reduced = 0;
  for (Index contacts = 2; contacts <= 10; ++contacts)
    for (int i = 0; i < count_of_each; ++i) {
      const FrictionalImpact impact = random_contacts(generator, contacts);
      const FrictionalImpulses found = frictional_impulses(impact);
      reduced += found.reduced;
      const double energy = 0.5 * found.impulses.dot(impact.rates + found.after);
      const double size = found.impulses.cwiseAbs().dot(impact.rates.cwiseAbs());
      ASSERT_LE(energy, 1e-12 * size);
      const Vector terms =
          impact.rates.cwiseAbs() + impact.matrix.cwiseAbs() * found.impulses.cwiseAbs();
      const double slow = 2e-11 * terms.maxCoeff();
      for (Index c = 0; c < contacts; ++c) {
        const double p = found.impulses[2 * c], t = found.impulses[2 * c + 1];
        const double mu = impact.contacts[static_cast<std::size_t>(c)].coefficient;
        const double light = 1e-11 * found.impulses.cwiseAbs().maxCoeff();
        ASSERT_GE(p, -light);
        ASSERT_LE(std::abs(t), mu * p + light);
        ASSERT_GE(found.after[2 * c], -slow);
        if (p > light && mu > 0) {
          ASSERT_LE(t * found.after[2 * c + 1], slow * std::abs(t));
        }
      }
    }
  EXPECT_LT(reduced, count_of_each / 2); // of nine times as many
}

TEST(FrictionalImpactsTest, SeveralAtOneInstantAreSolvedAndGainNoEnergy) {
  judge_random_contacts(50);
}
TEST(FrictionalImpactMany, SeveralAtOneInstantAreSolvedAndGainNoEnergy) {
  judge_random_contacts(9000);
}

// Contacts that do not act on each other are impacts by themselves.
TEST(FrictionalImpactsTest, ContactsApartAreImpactsAlone) {
  const PointImpact rod = falling_rod(RestitutionHypothesis::energetic);
  FrictionalImpact impact{
      .matrix = Matrix::Zero(4, 4),
      .rates = Vector(4),
      .contacts = {{.coefficient = 0.01, .at_rest = 0.01}, {}},
      .restitution = Vector::Constant(2, 1.0),
      .hypotheses = {RestitutionHypothesis::energetic, RestitutionHypothesis::energetic}};
  impact.matrix.topLeftCorner(2, 2) << rod.normal, rod.coupling, rod.coupling, rod.tangential;
  impact.matrix(2, 2) = 2;
  impact.rates << rod.gap_rate, rod.slip_rate, -3, 0;
  const FrictionalImpulses found = frictional_impulses(impact);
  const PointImpulse alone = impulse_at_point(rod);
  EXPECT_EQ(found.impulses.head(2), Vector(alone.impulse));
  EXPECT_NEAR(found.impulses[2], 3, 1e-14);
  EXPECT_NEAR(found.after[2], 3, 1e-14);
  EXPECT_NEAR(found.friction_work[0], -energy_change(rod, alone), 1e-14);
}

} // namespace frictional_impact_tests
} // namespace vibroimpact::contact
