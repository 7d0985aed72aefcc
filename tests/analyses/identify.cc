// Impacts of two free spheres, whose restitution and approach speed are known beforehand.
#include "analyses/identification/identify.h"

#include "common/error.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"
#include "contact/restitution_relation.h"
#include "support/lumped_models.h"
#include "text_of.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace identify_tests {

using namespace contact;

constexpr double sphere_stiffness = 1.3e10; // [N/m^1.5]
constexpr double clearance = 1e-4;          // [m]
constexpr HertzConstants spheres{.stiffness = sphere_stiffness, .exponent = 1.5};

// The first of two free masses flies at `speed` towards the second one, which rests.
System free_spheres(double mass_a, double mass_b, double speed,
                    const std::shared_ptr<const ContactLaw> &law, double gap = clearance) {
  model::Model model(
      {testing::single_mass("a", mass_a, 0, 0), testing::single_mass("b", mass_b, 0, 0)});
  ContactSet contacts({testing::contact_along_x(model, "a.head", "b.head", gap, law)});
  Vector velocity(2);
  velocity << speed, 0;
  return {.model = std::move(model),
          .contacts = std::move(contacts),
          .integration = {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-15},
          .initial = {.displacement = Vector::Zero(2), .velocity = velocity}};
}

std::shared_ptr<const ContactLaw> damped(double restitution, double speed) {
  return HuntCrossley::with_dissipation(spheres,
                                        dimensionless_damping("exact", restitution) / speed);
}

class OnePoint : public LineContext {
public:
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(PointResult result) override { result_ = std::move(result); }
  void skip() override {}

  const std::vector<double> &values(const std::string &name) const {
    for (const Field &field : result_.fields)
      if (field.name() == name)
        return field.values;
    throw std::logic_error("no field " + name);
  }
  double first(const std::string &name) const {
    return values("contact/heads/identification/" + name).at(0);
  }

private:
  PointResult result_;
};

OnePoint identified(System system, Identify::Settings settings) {
  settings.duration = 2 * clearance / system.initial.velocity[0] + 1e-3;
  const Identify analysis(settings);
  analysis.check(system);
  OnePoint point;
  analysis.run_line(0, system, point);
  return point;
}

const FormulaSet &set(std::size_t index) { return formula_sets()[index]; }
const FormulaSet &printed = set(0);
const FormulaSet &corrected = set(1);
const FormulaSet &exact = set(2);

TEST(Identify, RatioOfTheFreeCollisionHasItsKnownValues) {
  EXPECT_DOUBLE_EQ(free_collision_ratio(1, 1.5), 1);
  EXPECT_NEAR(dimensionless_damping("exact", 0.5), 1.432751, 1e-6);
  EXPECT_NEAR(free_collision_ratio(0.5, 1.5), 1.5744, 1e-4);
  EXPECT_NEAR(dimensionless_damping("exact", 0.7), 0.634828, 1e-6);
  EXPECT_NEAR(free_collision_ratio(0.7, 1.5), 1.1694, 1e-4);
}

// The largest of u^n (1 + d u') over the whole motion, u from the energy integral by quadrature.
TEST(Identify, RatioOfTheFreeCollisionAgreesWithASearchOverTheMotion) {
  for (const double n : {1.0, 1.5, 2.5})
    for (const double e : {0.1, 0.4, 0.8}) {
      const double d = dimensionless_damping("exact", e);
      double largest = 0;
      for (int i = 0; i < 4000; ++i) {
        const double v = 1 - i / 4000.0;
        const double energy = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
            [d](double w) { return w / (1 + d * w); }, v, 1.0);
        largest = std::max(largest, std::pow((n + 1) * energy, n / (n + 1)) * (1 + d * v));
      }
      const double ratio = 8 * std::pow(largest, (n + 1) / n) / ((n + 1) * (1 + e) * (1 + e));
      EXPECT_NEAR(free_collision_ratio(e, n), ratio, 1e-6 * ratio) << "n " << n << ", e " << e;
    }
}

TEST(Identify, RatioIsInvertedBackToTheRestitution) {
  for (const double e : {1e-3, 0.05, 0.2, 0.33377, 0.5, 0.7, 0.9, 0.99})
    EXPECT_NEAR(free_collision_restitution(free_collision_ratio(e, 1.5), 1.5), e, 1e-10);
  EXPECT_EQ(free_collision_restitution(1, 1.5), 1);
  EXPECT_TRUE(std::isnan(free_collision_restitution(0.999, 1.5)));
  EXPECT_EQ(free_collision_restitution(1e12, 1.5), 0);
}

TEST(Identify, ExactSetFindsWhatTwoFreeSpheresDid) {
  for (const double e : {0.2, 0.33377, 0.5, 0.7, 0.9})
    for (const double speed : {0.05, 2.0}) {
      const OnePoint point = identified(free_spheres(0.1, 0.3, speed, damped(e, speed)), {});
      const double factor = sphere_stiffness * dimensionless_damping("exact", e) / speed;
      EXPECT_NEAR(point.first("compliance"), 1 / 0.1 + 1 / 0.3, 1e-12);
      EXPECT_NEAR(point.first("damping_factor"), factor, 1e-12 * factor);
      EXPECT_NEAR(point.first("exact/restitution_coefficient"), e, 1e-5 * e);
      EXPECT_NEAR(point.first("exact/approach_speed"), speed, 1e-5 * speed);
      EXPECT_NEAR(point.first("exact/damping_factor"), factor, 1e-5 * factor);
      EXPECT_NEAR(point.first("exact/constant_damping_factor"), factor, 1e-5 * factor);
    }
}

TEST(Identify, CorrectedSetSeesTooMuchDamping) {
  const OnePoint point = identified(free_spheres(0.1, 0.3, 1, damped(0.95, 1)), {});
  const double loss = 1 - point.first("corrected/restitution_coefficient");
  EXPECT_GT(loss / 0.05, 2);
  EXPECT_LT(loss / 0.05, 3);
}

// 1 - e of the corrected set is 2 sqrt(gamma - 1) to first order.
TEST(Identify, CorrectedLossIsTwelveFifthsOfTheTrueOneInTheElasticLimit) {
  const double loss = 1e-3;
  const double ratio = free_collision_ratio(1 - loss, 1.5);
  EXPECT_NEAR((1 - corrected.restitution(ratio, 1, 1.5)) / loss, 2.4, 0.01);
}

TEST(Identify, CorrectedSetSolvesItsEnergyBalance) {
  const ContactConstants contact{.compliance = 7, .stiffness = 2e9, .exponent = 1.5};
  const PulseFigures pulse{.impulse = 0.2, .peak_force = 1300};
  const double v = identify(corrected, pulse, contact, {}).approach_speed;
  const double momentum = pulse.impulse * contact.compliance;
  const double energy = 2 * contact.compliance * contact.stiffness / 2.5 *
                        std::pow(pulse.peak_force / contact.stiffness, 5.0 / 3);
  EXPECT_NEAR(v * v - momentum * v + momentum * momentum / 2, energy, 1e-12 * energy);
}

TEST(Identify, PrintedSetIsTheCorrectedOneOnlyForUnitCompliance) {
  const ContactConstants contact{.compliance = 13, .stiffness = 2e9, .exponent = 1.5};
  const PulseFigures pulse{.impulse = 0.2, .peak_force = 1800};
  const Identified right = identify(corrected, pulse, contact, {});
  // Lengths in mm, times in 10 ms and forces in such units that lambda becomes 1.
  const Scales unit{.length = 1e-3, .time = 1e-2, .force = 1e-3 / (13 * 1e-4)};
  const Identified same = identify(printed, pulse, contact, unit);
  EXPECT_NEAR(same.restitution, right.restitution, 1e-13);
  EXPECT_NEAR(same.approach_speed, right.approach_speed, 1e-12);
  EXPECT_NEAR(same.damping_factor, right.damping_factor, 1e-12 * right.damping_factor);
  const Scales other{.length = 1e-3, .time = 1e-2, .force = 1.8 * unit.force};
  EXPECT_GT(std::abs(identify(printed, pulse, contact, other).restitution - right.restitution),
            0.05);
}

TEST(Identify, PrintedSetSolvesItsOwnQuadraticInItsUnits) {
  const Scales scales{.length = 0.3, .time = 0.08, .force = 2.4};
  const ContactConstants contact{.compliance = 34, .stiffness = 1.3e10, .exponent = 1.5};
  const PulseFigures pulse{.impulse = 0.04, .peak_force = 1800};
  const double lambda = scales.dimensionless(contact.compliance);
  const double impulse = pulse.impulse / (scales.force * scales.time);
  const double peak = pulse.peak_force / scales.force;
  const double k = contact.stiffness * std::pow(scales.length, 1.5) / scales.force;
  const double v =
      identify(printed, pulse, contact, scales).approach_speed * scales.time / scales.length;
  const double rest =
      2 * lambda * (std::pow(impulse * lambda / 2, 2) - k * std::pow(peak / k, 5.0 / 3) / 2.5);
  EXPECT_NEAR(v * v - impulse * lambda * lambda * v + rest, 0, 1e-12 * v * v);
}

TEST(Identify, IntervalHoldsTheTruthOfAWrongMeasurement) {
  const Uncertainties uncertainties{
      .impulse = 0.01, .peak_force = 0.01, .compliance = 0.02, .stiffness = 0.02};
  const ContactConstants contact{.compliance = 13, .stiffness = 2e9, .exponent = 1.5};
  for (const double e : {0.2, 0.5, 0.7, 0.9}) {
    // A pulse of ratio gamma(e), read 0.9 % too high and 0.9 % too low.
    const double impulse = 0.1;
    const double peak = contact.stiffness * std::pow(free_collision_ratio(e, 1.5) * 2.5 * impulse *
                                                         impulse * 13 / (8 * contact.stiffness),
                                                     0.6);
    for (const double sign : {-1.0, 1.0}) {
      const PulseFigures read{.impulse = impulse * (1 - 0.009 * sign),
                              .peak_force = peak * (1 + 0.009 * sign)};
      const ContactConstants assumed{.compliance = 13 * (1 - 0.018 * sign),
                                     .stiffness = 2e9 * (1 - 0.018 * sign),
                                     .exponent = 1.5};
      const Interval interval = restitution_interval(exact, read, assumed, {}, uncertainties);
      EXPECT_LT(interval.low, e);
      EXPECT_GT(interval.high, e);
      EXPECT_LE(interval.high, 1);
    }
  }
}

TEST(Identify, IntervalReachesOneWhereTheInversionIsIllPosed) {
  const ContactConstants contact{.compliance = 1, .stiffness = 1, .exponent = 1.5};
  const auto interval_at = [&contact](double e) {
    const PulseFigures pulse{.impulse = 1,
                             .peak_force = std::pow(free_collision_ratio(e, 1.5) * 2.5 / 8, 0.6)};
    return restitution_interval(exact, pulse, contact, {}, {.compliance = 0.02});
  };
  EXPECT_EQ(interval_at(0.95).high, 1);
  EXPECT_LT(interval_at(0.8).high, 0.9);
}

// Two bodies that are pressed together have a long pulse: an impulse without a peak.
TEST(Identify, IntervalOfALongPushIsEmpty) {
  const ContactConstants contact{.compliance = 1, .stiffness = 1, .exponent = 1.5};
  const Interval interval = restitution_interval(exact, {.impulse = 1, .peak_force = 0.1}, contact,
                                                 {}, {.impulse = 0.01, .compliance = 0.02});
  EXPECT_TRUE(std::isnan(interval.low));
  EXPECT_TRUE(std::isnan(interval.high));
}

TEST(Identify, FitsFindTheLawsThatMadeTheImpacts) {
  std::vector<Identified> impacts;
  for (const double v : {0.1, 0.4, 2.0})
    impacts.push_back(
        {.restitution = 0.6 * std::pow(v / 3, -0.1), .approach_speed = v, .damping_factor = 5});
  impacts.push_back(
      {.restitution = std::nan(""), .approach_speed = 1, .damping_factor = std::nan("")});
  impacts.push_back({.restitution = 0, .approach_speed = 5, .damping_factor = std::nan("")});
  const PowerFit fit = fit_power(impacts, 3); // ln 0 is nothing to fit
  EXPECT_EQ(fit.impacts, 3U);
  EXPECT_NEAR(fit.coefficient, 0.6, 1e-12);
  EXPECT_NEAR(fit.exponent, -0.1, 1e-12);
  EXPECT_NEAR(constant_damping_factor(impacts), 5, 1e-12);
  // mu v_c = 1, 3 at v_c = 1, 2: the slope through the origin is (1 + 6)/(1 + 4).
  EXPECT_NEAR(constant_damping_factor({{.approach_speed = 1, .damping_factor = 1},
                                       {.approach_speed = 2, .damping_factor = 1.5}}),
              1.4, 1e-12);
  EXPECT_TRUE(std::isnan(fit_power({impacts[0], impacts[0]}, 1).exponent));
}

// A Hertz contact of mass m lasts 2.9432 delta/v with delta = (5 m v^2/(4 k))^(2/5).
TEST(Identify, SamplingAPulseOfAHundredMicrosecondsAtAHundredKilohertz) {
  const double mass = 0.05; // that meets at the contact
  const double target = 100e-6;
  const double speed =
      std::pow(2.9432 * std::pow(5 * mass / (4 * sphere_stiffness), 0.4) / target, 5);
  constexpr int phases = 25;
  double missed = 0;
  for (int i = 0; i < phases; ++i) {
    const double gap = clearance + speed * 1e-5 * i / phases;
    const OnePoint point =
        identified(free_spheres(2 * mass, 2 * mass, speed, std::make_shared<Hertz>(spheres), gap),
                   {.sampling_frequency = 1e5});
    EXPECT_NEAR(point.values("contact/heads/impact/duration").at(0), target, 0.01 * target);
    const double peak = point.values("contact/heads/impact/peak_force").at(0);
    const double impulse = point.values("contact/heads/impact/impulse").at(0);
    EXPECT_NEAR(point.first("impulse"), impulse, 2e-3 * impulse);
    missed += (1 - point.first("peak_force") / peak) / phases;
  }
  EXPECT_GT(missed, 1e-3);
  EXPECT_LT(missed, 1e-2);
}

TEST(Identify, PulseBetweenTwoSamplesIsNotSeen) {
  const OnePoint point =
      identified(free_spheres(0.1, 0.1, 1, damped(0.5, 1)), {.sampling_frequency = 1e3 / 1.7});
  EXPECT_EQ(point.first("impulse"), 0);
  EXPECT_EQ(point.first("peak_force"), 0);
  for (const FormulaSet &formulas : formula_sets()) {
    const std::string name = formulas.name;
    EXPECT_TRUE(std::isnan(point.first(name + "/restitution_coefficient")));
    EXPECT_TRUE(std::isnan(point.first(name + "/restitution_low")));
    EXPECT_TRUE(std::isnan(point.first(name + "/restitution_high")));
  }
}

TEST(Identify, RecordHoldsEverySampleOfTheMotion) {
  const OnePoint point =
      identified(free_spheres(0.1, 0.1, 1, damped(0.5, 1)), {.sampling_frequency = 1e5});
  const std::vector<double> &time = point.values("contact/heads/identification/record/time");
  EXPECT_EQ(time.size(), 121U); // 1.2 ms
  EXPECT_EQ(point.values("contact/heads/identification/record/force").size(), time.size());
  EXPECT_NEAR(time.back(), 1.2e-3, 1e-12);
}

TEST(Identify, MapAgreesWithTheSingleImpact) {
  const OnePoint point = identified(free_spheres(0.1, 0.3, 1, damped(0.5, 1)), {.map_points = 7});
  // The largest pulse stands five sixths up both axes.
  EXPECT_NEAR(point.first("exact/restitution_coefficient"),
              point.values("contact/heads/identification/exact/restitution_map").at(5 * 7 + 5),
              1e-9);
  EXPECT_NEAR(point.values("contact/heads/identification/impulse_axis").at(5),
              point.first("impulse"), 1e-12);
}

TEST(Identify, LawWithoutAPowerOfThePenetrationIsRefused) {
  const System system = free_spheres(1, 1, 1, std::make_shared<LinearPenalty>(1e6));
  const std::string message =
      testing::thrown_message<InputError>([&] { Identify({.duration = 1}).check(system); });
  EXPECT_NE(message.find("linear penalty"), std::string::npos) << message;
}

TEST(Identify, UnknownContactIsRefused) {
  const System system = free_spheres(1, 1, 1, damped(0.5, 1));
  const std::string message = testing::thrown_message<InputError>(
      [&] { Identify({.duration = 1, .contact = "tails"}).check(system); });
  EXPECT_NE(message.find("tails"), std::string::npos) << message;
}

} // namespace identify_tests
} // namespace vibroimpact::analyses
