// A law given as a table: one or two lines are springs, whose motion is known; a stop that crushes
// leaves and takes what the areas below its curves say.
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/crushable_table.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/table.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::contact {
namespace table_law_tests {

using namespace motion;

constexpr double mass = 2;
constexpr double stiffness = 8e4;

struct Outcome {
  std::vector<Impact> impacts;
  MotionState end;
  double work_error = 0;
};

// A mass on a spring [N/m] whose stop is `clearance` away, at a speed.
Outcome run(const std::shared_ptr<const ContactLaw> &law, double spring, double clearance,
            double speed, double duration, const std::vector<double> &internal = {},
            const std::string &method = "exact") {
  const model::Model model({testing::single_mass("block", mass, spring, 0)});
  const ContactSet contacts({testing::contact_along_x(model, "block.head", "", clearance, law)});
  Settings settings;
  settings.method = method;
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  testing::GuardWatch guards;
  Observers observers({&log, &guards});
  Vector state(2 + law->n_internal());
  state << 0, speed, Vector::Map(law->initial_internal().data(), law->n_internal());
  if (!internal.empty())
    state.tail(law->n_internal()) = Vector::Map(internal.data(), law->n_internal());
  trajectory.start({.time = 0, .physical = state});
  trajectory.advance(duration, observers);
  return {log.impacts(0), trajectory.motion_state(), trajectory.accuracy().energy_residual};
}

void expect_same_motion(const std::shared_ptr<const ContactLaw> &table,
                        const std::shared_ptr<const ContactLaw> &known, double accuracy) {
  const Outcome one = run(table, 2e3, 1e-3, 0.5, 3);
  const Outcome other = run(known, 2e3, 1e-3, 0.5, 3);
  ASSERT_EQ(one.impacts.size(), other.impacts.size());
  EXPECT_GT(one.impacts.size(), 5u);
  EXPECT_NEAR(one.end.physical[0], other.end.physical[0], accuracy * 1e-2);
  EXPECT_NEAR(one.end.physical[1], other.end.physical[1], accuracy);
  for (std::size_t i = 0; i < one.impacts.size(); ++i) {
    EXPECT_NEAR(one.impacts[i].impulse, other.impacts[i].impulse, accuracy);
    EXPECT_NEAR(one.impacts[i].dissipated_energy, other.impacts[i].dissipated_energy, accuracy);
  }
}

ForceCurve line(const std::vector<double> &places) {
  std::vector<double> forces;
  for (const double u : places)
    forces.push_back(stiffness * u);
  return {places, forces};
}

TEST(TableLawTest, OneLineIsALinearPenalty) {
  const auto known = std::make_shared<LinearPenalty>(stiffness);
  expect_same_motion(std::make_shared<Table>(line({0, 1e-3}), 0, false), known, 1e-12);
  expect_same_motion(std::make_shared<Table>(line({0, 3e-4, 1e-3, 2e-3}), 0, false), known, 1e-12);
}

TEST(TableLawTest, WithADashpotItIsABilinearOrAKelvinVoigtStop) {
  const double damping = 60;
  for (const bool pulls : {true, false}) {
    std::shared_ptr<const ContactLaw> known = std::make_shared<KelvinVoigt>(stiffness, damping);
    if (pulls)
      known = std::make_shared<BilinearStop>(stiffness, damping);
    for (const auto &places : {std::vector<double>{0, 1e-3}, {0, 3e-4, 1e-3, 2e-3}})
      expect_same_motion(std::make_shared<Table>(line(places), damping, pulls), known, 1e-12);
  }
}

// Up to u_1 on k_1 it is a sine that began with v; the rest is a sine about -F_1/k_2.
TEST(TableLawTest, TwoLinesAreTwoSines) {
  const double k1 = 5e4, k2 = 4e5, u1 = 1e-3, speed = 0.5;
  const auto law =
      std::make_shared<Table>(ForceCurve({0, u1, 2 * u1}, {0, k1 * u1, (k1 + k2) * u1}), 0, false);
  const double w1 = std::sqrt(k1 / mass), w2 = std::sqrt(k2 / mass);
  const double v1 = std::sqrt(speed * speed - w1 * w1 * u1 * u1);
  const double half = std::asin(w1 * u1 / speed) / w1 + std::atan2(w2 * v1, k1 * u1 / mass) / w2;
  const Outcome out = run(law, 0, 0, speed, 0.1);
  ASSERT_EQ(out.impacts.size(), 1u);
  EXPECT_NEAR(out.impacts[0].duration, 2 * half, 1e-12 * half);
  EXPECT_NEAR(out.impacts[0].restitution_coefficient(), 1, 1e-12);
  const double peak = std::hypot(k1 * u1, std::sqrt(k2 * mass) * v1);
  EXPECT_NEAR(out.impacts[0].peak_force, peak, 1e-10 * peak);
}

// The points of code_aster's test SDND110c, and the force between and behind them.
TEST(TableLawTest, PublishedPointsAreMet) {
  const Table law(ForceCurve({0, 0.2, 0.5, 0.7, 0.95, 1}, {0, 400, 450, 600, 700, 1000}), 0, false);
  for (const auto &[penetration, force] : {std::pair{0.1, 200.0},
                                           {0.2, 400.0},
                                           {0.3, 400 + 50 / 3.0},
                                           {0.5, 450.0},
                                           {0.6, 525.0},
                                           {0.7, 600.0},
                                           {0.825, 650.0},
                                           {0.95, 700.0},
                                           {0.975, 850.0},
                                           {1.0, 1000.0},
                                           {1.1, 1600.0}}) {
    const LocalState state{.gap = -penetration};
    LawResponse response;
    law.evaluate(law.initial_mode(state), state, response);
    EXPECT_NEAR(response.force, force, 1e-11) << penetration;
  }
}

TEST(TableLawTest, DerivativesPowerAndAffineForm) {
  const ForceCurve curve({0, 5e-4, 2e-3}, {0, 30, 200});
  for (const bool pulls : {true, false}) {
    const Table law(curve, 150, pulls);
    for (int mode = 0; mode < static_cast<int>(law.modes().size()); ++mode)
      for (const double rate : {-0.3, 0.4})
        testing::check_law(law, {.mode = mode, .gap = mode == 0 ? 1e-3 : -1e-3, .gap_rate = rate});
  }
}

TEST(TableLawTest, OneLineHasAnElasticForceAndPullsOnlyWhereAsked) {
  EXPECT_TRUE(Table(line({0, 1e-3}), 0, true).elastic_force());
  EXPECT_FALSE(Table(line({0, 1e-3, 2e-3}), 0, true).elastic_force());
  EXPECT_FALSE(Table(line({0, 1e-3}), 0, true).may_pull());
  EXPECT_FALSE(Table(line({0, 1e-3}), 10, false).may_pull());
  EXPECT_TRUE(Table(line({0, 1e-3}), 10, true).may_pull());
}

// f = 8e4 u up to 1 mm, then 2e4 N/m less steep; unloading with 2e5 N/m.
const ForceCurve crush({0, 1e-3, 5e-3}, {0, 80, 160});
constexpr double unloading_stiffness = 2e5;

double crushing_area(double u) {
  return u < 1e-3 ? 4e4 * u * u : 0.04 + 80 * (u - 1e-3) + 1e4 * (u - 1e-3) * (u - 1e-3);
}

std::shared_ptr<const ContactLaw> crushable(const ForceCurve &loading,
                                            const std::optional<ForceCurve> &unloading = {}) {
  return std::make_shared<CrushableTable>(CrushCurves(loading, unloading, unloading_stiffness));
}

// Speed that goes down to a penetration.
double speed_to(double area) { return std::sqrt(2 * area / mass); }

TEST(TableLawTest, ACrushedStopKeepsWhatTheCurveSays) {
  const auto law = crushable(crush);
  for (const double deepest : {4e-4, 2.5e-3, 7e-3}) {
    const double speed = speed_to(crushing_area(deepest));
    const double force = crush(deepest);
    const double residual = deepest - force / unloading_stiffness;
    const double returned = force * force / (2 * unloading_stiffness);
    for (const std::string method : {"exact", "rk"}) {
      const double accuracy = method == "exact" ? 1e-12 : 1e-7;
      const Outcome out = run(law, 0, 1e-3, speed, 0.3, {}, method);
      ASSERT_EQ(out.impacts.size(), 1u) << deepest;
      EXPECT_NEAR(out.end.physical[2], residual, accuracy * deepest) << deepest;
      EXPECT_NEAR(out.impacts[0].peak_force, force, 100 * accuracy * force) << deepest;
      EXPECT_NEAR(out.impacts[0].dissipated_energy, crushing_area(deepest) - returned,
                  accuracy * crushing_area(deepest))
          << deepest;
      EXPECT_NEAR(out.end.physical[1], -speed_to(returned), accuracy * speed) << deepest;
      EXPECT_LT(out.work_error, 1e-8);
    }
  }
}

// The second impact is elastic up to the force of the first one, and then goes on along the curve.
TEST(TableLawTest, TheResidualPenetrationGrowsFromImpactToImpact) {
  const auto law = crushable(crush);
  const double first = 2.5e-3, second = 6e-3;
  const double force = crush(first);
  const double residual = first - force / unloading_stiffness;
  const double stored = force * force / (2 * unloading_stiffness);
  const Outcome soft = run(law, 0, 1e-3, speed_to(0.99 * stored), 0.3, {residual});
  EXPECT_NEAR(soft.end.physical[2], residual, 1e-15);
  EXPECT_NEAR(soft.impacts.at(0).dissipated_energy, 0, 1e-14);
  EXPECT_NEAR(soft.impacts.at(0).restitution_coefficient(), 1, 1e-12);
  const double area = stored + crushing_area(second) - crushing_area(first);
  const Outcome hard = run(law, 0, 1e-3, speed_to(area), 0.3, {residual});
  EXPECT_NEAR(hard.end.physical[2], second - crush(second) / unloading_stiffness, 1e-12 * second);
  // The stop is met where it has been left.
  EXPECT_NEAR(hard.impacts.at(0).start_time, (1e-3 + residual) / speed_to(area), 1e-14);
}

// Elastic up to 1 mm with the stiffness of unloading.
TEST(TableLawTest, AnElasticBeginningLeavesNothing) {
  const auto law = crushable(ForceCurve({0, 1e-3, 5e-3}, {0, 200, 240}));
  const Outcome elastic = run(law, 0, 1e-3, speed_to(0.099), 0.3);
  EXPECT_NEAR(elastic.end.physical[2], 0, 1e-15);
  EXPECT_NEAR(elastic.impacts.at(0).restitution_coefficient(), 1, 1e-12);
  const double deepest = 3e-3;
  const double area = 0.1 + 200 * 2e-3 + 0.5 * 1e4 * 4e-6;
  const Outcome yielding = run(law, 0, 1e-3, speed_to(area), 0.3);
  EXPECT_NEAR(yielding.end.physical[2], deepest - 220 / unloading_stiffness, 1e-12 * deepest);
}

// Area of a polygon by its corners (Gauss).
double polygon_area(const std::vector<std::pair<double, double>> &corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &[x, y] = corners[i];
    const auto &[u, w] = corners[(i + 1) % corners.size()];
    twice += u * y - x * w;
  }
  return std::abs(twice) / 2;
}

TEST(TableLawTest, AHystereticImpactTakesTheAreaBetweenTheCurves) {
  const ForceCurve unloading({0, 2e-3, 4e-3}, {0, 10, 45});
  const auto law = crushable(crush, unloading);
  for (const double deepest : {8e-4, 2.2e-3, 4.5e-3}) {
    const double force = crush(deepest);
    // Where the line meets the unloading curve.
    const double on_first = (unloading_stiffness * deepest - force) / (unloading_stiffness - 5e3);
    const double on_second =
        (unloading_stiffness * deepest - force - 25) / (unloading_stiffness - 1.75e4);
    const double met = on_first < 2e-3 ? on_first : on_second;
    std::vector<std::pair<double, double>> corners = {{0, 0}};
    if (deepest > 1e-3)
      corners.emplace_back(1e-3, 80);
    corners.emplace_back(deepest, force);
    corners.emplace_back(met, unloading(met));
    if (met > 2e-3)
      corners.emplace_back(2e-3, 10);
    const Outcome out = run(law, 0, 1e-3, speed_to(crushing_area(deepest)), 0.3);
    ASSERT_EQ(out.impacts.size(), 1u) << deepest;
    EXPECT_NEAR(out.impacts[0].dissipated_energy, polygon_area(corners),
                1e-12 * crushing_area(deepest))
        << deepest;
    EXPECT_EQ(out.end.physical[2], 0) << deepest;
    EXPECT_LT(out.work_error, 1e-10);
  }
}

// Where the unloading curve is zero up to 0.5 mm, this much stays and no more.
TEST(TableLawTest, AnUnloadingCurveMayLeaveAResidue) {
  const auto law = crushable(crush, ForceCurve({0, 5e-4, 4e-3}, {0, 0, 60}));
  const Outcome deep = run(law, 0, 1e-3, speed_to(crushing_area(3e-3)), 0.3);
  EXPECT_NEAR(deep.end.physical[2], 5e-4, 1e-18);
  const Outcome again = run(law, 0, 1e-3, speed_to(crushing_area(3e-3)), 0.3, {5e-4});
  EXPECT_NEAR(again.end.physical[2], 5e-4, 1e-18);
  EXPECT_NEAR(again.impacts.at(0).start_time, 1.5e-3 / speed_to(crushing_area(3e-3)), 1e-14);
}

// A mass that is driven, with impacts of all sizes that turn in mid way.
TEST(TableLawTest, ManyImpactsKeepTheEnergyBalance) {
  for (const auto &law :
       {crushable(crush), crushable(crush, ForceCurve({0, 2e-3, 4e-3}, {0, 10, 45})),
        crushable(ForceCurve({0, 1e-3, 5e-3}, {0, 200, 240}))}) {
    const Outcome exact = run(law, 3e4, -2e-4, 0.7, 1);
    const Outcome steps = run(law, 3e4, -2e-4, 0.7, 1, {}, "rk");
    EXPECT_LT(exact.work_error, 1e-10);
    EXPECT_NEAR(exact.end.physical[0], steps.end.physical[0], 1e-7);
    EXPECT_NEAR(exact.end.physical[2], steps.end.physical[2], 1e-8);
  }
}

TEST(TableLawTest, DerivativesPowerAndAffineFormOfCrushing) {
  for (const auto &law :
       {crushable(crush), crushable(crush, ForceCurve({0, 2e-3, 4e-3}, {0, 10, 45}))})
    for (int mode = 0; mode < static_cast<int>(law->modes().size()); ++mode)
      for (const double rate : {-0.3, 0.4})
        testing::check_law(*law,
                           {.mode = mode, .gap = -2.1e-3, .gap_rate = rate, .internal = {1e-3}});
}

TEST(TableLawTest, CurvesThatCannotBeAreRefused) {
  EXPECT_THROW(crushable(ForceCurve({0, 1e-3}, {0, 300})), std::invalid_argument);
  EXPECT_THROW(crushable(ForceCurve({0, 1e-3}, {0, 200})), std::invalid_argument);
  EXPECT_THROW(crushable(crush, ForceCurve({0, 1e-3}, {0, 90})), std::invalid_argument);
  EXPECT_THROW(crushable(crush, ForceCurve({0, 5e-3, 6e-3}, {0, 100, 150})), std::invalid_argument);
}

} // namespace table_law_tests
} // namespace vibroimpact::contact
