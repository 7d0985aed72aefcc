// A law given as a formula: each law of the program that is a formula of penetration and rate,
// written as one, moves in the same way.
#include "common/error.h"
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/formula.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/tsuji.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::contact {
namespace formula_law_tests {

using namespace motion;

std::shared_ptr<const FormulaLaw> formula(const std::string &text,
                                          Tension tension = Tension::refused,
                                          double largest_penetration = 2e-3) {
  return std::make_shared<FormulaLaw>(parameters::Formula(text, {}, {"x", "v"}),
                                      largest_penetration, tension);
}

struct Case {
  std::shared_ptr<const ContactLaw> known;
  std::shared_ptr<const FormulaLaw> written;
  bool whole = false; ///< solved in one step
  /// In other operations, which round differently: steps carry that into their lengths.
  bool other_rounding = false;
};

std::vector<Case> cases() {
  const HertzConstants hertz{.stiffness = 2e7, .exponent = 1.5};
  return {
      {std::make_shared<LinearPenalty>(8e4), formula("8e4*x")},
      {std::make_shared<BilinearStop>(8e4, 60), formula("8e4*x + 60*v", Tension::pulls)},
      {std::make_shared<KelvinVoigt>(8e4, 60), formula("60*v + x*8e4", Tension::cut_off)},
      {std::make_shared<Hertz>(hertz), formula("2e7*sqrt(x)*x"), true},
      {std::make_shared<Hertz>(hertz), formula("2e7*x^1.5"), true, true},
      {std::make_shared<Hertz>(HertzConstants{.stiffness = 4e6, .exponent = 1.3}),
       formula("4e6*x^(1.3 - 1)*x"), true},
      {HuntCrossley::with_dissipation(hertz, 0.8), formula("2e7*sqrt(x)*x*(1 + 0.8*v)"), true},
      {HuntCrossley::with_dissipation(hertz, 1.5),
       formula("2e7*sqrt(x)*x*(1 + 1.5*v)", Tension::cut_off), true},
      {HuntCrossley::with_dissipation(hertz, 0.8), formula("(1 + 0.8*v)*2e7*x^1.5"), true, true},
      {std::make_shared<Tsuji>(2e7, 400),
       formula("2e7*sqrt(x)*x + 400*sqrt(sqrt(x))*v", Tension::pulls), true},
      {std::make_shared<Tsuji>(2e7, 400), formula("2e7*x^1.5 + 400*x^0.25*v", Tension::pulls), true,
       true},
      {std::make_shared<KuwabaraKono>(2e7, 2e-5),
       formula("2e7*sqrt(x)*(x + 3e-5*v)", Tension::cut_off), false, true},
  };
}

struct Outcome {
  std::vector<Impact> impacts;
  Vector end;
  Accuracy accuracy;
};

Outcome run(const std::shared_ptr<const ContactLaw> &law, const std::string &method,
            double duration = 1) {
  const model::Model model({testing::single_mass("block", 2, 2e3, 1)});
  const ContactSet contacts({testing::contact_along_x(model, "block.head", "", 1e-3, law)});
  Settings settings;
  settings.method = method;
  Trajectory trajectory(model, contacts, settings);
  ImpactLog log(contacts, 0);
  Observers observers({&log});
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 0.4));
  trajectory.advance(duration, observers);
  return {log.impacts(0), trajectory.state().head(2), trajectory.accuracy()};
}

TEST(FormulaLawTest, LawsOfTheProgramWrittenAsFormulasMoveInTheSameWay) {
  for (const Case &law : cases())
    for (const std::string method : {"exact", "rk"}) {
      if (method == "rk" && law.other_rounding)
        continue;
      const Outcome one = run(law.written, method);
      const Outcome other = run(law.known, method);
      const std::string where = law.known->name() + ", " + method;
      ASSERT_EQ(one.impacts.size(), other.impacts.size()) << where;
      EXPECT_GT(one.impacts.size(), 3u);
      EXPECT_EQ(one.accuracy.contact_episodes, other.accuracy.contact_episodes) << where;
      EXPECT_EQ(one.accuracy.contact_episodes > 0, law.whole && method == "exact") << where;
      EXPECT_NEAR(one.end[0], other.end[0], 1e-12) << where;
      EXPECT_NEAR(one.end[1], other.end[1], 1e-12) << where;
      for (std::size_t i = 0; i < one.impacts.size(); ++i) {
        EXPECT_NEAR(one.impacts[i].dissipated_energy, other.impacts[i].dissipated_energy, 1e-12)
            << where;
        EXPECT_NEAR(one.impacts[i].peak_force / other.impacts[i].peak_force, 1, 1e-12) << where;
      }
      EXPECT_LT(one.accuracy.energy_residual, 1e-7) << where;
    }
}

TEST(FormulaLawTest, TheirDerivativesAndEnergiesAreTheSame) {
  for (const Case &law : cases())
    for (const double u : {1e-7, 3e-5, 4e-4})
      for (const double v : {-0.3, 0.0, 0.7}) {
        const testing::LawPoint point{.mode = 1, .gap = -u, .gap_rate = -v};
        const LawResponse one = testing::response_of(*law.written, point);
        const LawResponse other = testing::response_of(*law.known, point);
        const auto same = [&](double a, double b) {
          EXPECT_NEAR(a, b, 4e-15 * std::abs(b) + 1e-300) << law.known->name();
        };
        EXPECT_NEAR(one.force, other.force, 1e-14 * std::abs(other.force) + 1e-13);
        EXPECT_NEAR(one.force_by_gap, other.force_by_gap,
                    1e-13 * (std::abs(other.force_by_gap) + std::abs(other.force) / u) + 1e-10);
        same(one.force_by_gap_rate, other.force_by_gap_rate);
        EXPECT_NEAR(one.stored_energy, other.stored_energy, 1e-13 * other.stored_energy);
        EXPECT_NEAR(one.dissipated_power, other.dissipated_power, 1e-13 * std::abs(one.force * v));
      }
}

TEST(FormulaLawTest, DerivativesPowerAndAffineForm) {
  for (const Case &law : cases())
    for (int mode = 0; mode < static_cast<int>(law.written->modes().size()); ++mode)
      for (const double rate : {-0.3, 0.4})
        testing::check_law(*law.written,
                           {.mode = mode, .gap = mode == 0 ? 1e-3 : -1e-4, .gap_rate = rate});
  for (const std::string text : {"1e5*x + 1e9*x^2 + 30*x*v", "1e3*tanh(x/1e-4)*exp(0.2*v)",
                                 "max(8e4*x, 2e5*x - 20)", "sqrt(1e5*x)*(2 + sin(v))/(1 + x/1e-3)"})
    for (const double rate : {-0.3, 0.4})
      testing::check_law(*formula(text), {.mode = 1, .gap = -2e-4, .gap_rate = rate});
}

// Antiderivatives by hand.
TEST(FormulaLawTest, TheStoredEnergyIsTheIntegralOfTheForceAtRest) {
  struct Known {
    std::string text;
    double (*energy)(double);
  };
  for (const Known &known :
       {Known{"1e5*x + 1e9*x^2.5",
              [](double x) { return 5e4 * x * x + 1e9 / 3.5 * std::pow(x, 3.5); }},
        Known{"300*tanh(x/1e-4)", [](double x) { return 0.03 * std::log(std::cosh(x / 1e-4)); }},
        Known{"400*(exp(x/2e-4) - 1)",
              [](double x) { return 400 * (2e-4 * std::expm1(x / 2e-4) - x); }},
        Known{"max(8e4*x, 2e5*x - 20)", [](double x) {
                const double corner = 20 / 1.2e5;
                return x < corner ? 4e4 * x * x
                                  : 4e4 * corner * corner + 1e5 * (x * x - corner * corner) -
                                        20 * (x - corner);
              }}})
    for (const double x : {1e-8, 3e-5, 1.7e-4, 1.5e-3}) {
      const double stored =
          testing::response_of(*formula(known.text), {.mode = 1, .gap = -x, .gap_rate = 0.2})
              .stored_energy;
      EXPECT_NEAR(stored / known.energy(x), 1, x < 1e-6 ? 1e-6 : 1e-12) << known.text << " " << x;
    }
}

// A force that is no power takes steps.
TEST(FormulaLawTest, ASumOfPowersIsSteppedAndKeepsItsEnergy) {
  const Outcome out = run(formula("1e5*x + 1e9*x^2.5"), "exact");
  EXPECT_EQ(out.accuracy.contact_episodes, 0);
  EXPECT_LT(out.accuracy.energy_residual, 1e-8);
  EXPECT_NEAR(out.impacts.at(0).dissipated_energy, 0, 1e-9);
}

// Found by the factor that changes its sign, and by trial after each step.
TEST(FormulaLawTest, AForceThatPullsDuringTheMotionFailsThere) {
  for (const std::string text :
       {"2e7*sqrt(x)*(x + 3e-4*v)", "2e7*x^1.5 + 400*x^0.25*v", "8e4*x + 60*v"})
    for (const std::string method : {"exact", "rk"}) {
      const auto law = formula(text);
      EXPECT_EQ(law->fault_at_rest(), "");
      try {
        run(law, method);
        ADD_FAILURE() << text << ", " << method;
      } catch (const NumericalError &error) {
        EXPECT_NE(std::string(error.what()).find("contact heads pulls at a penetration of"),
                  std::string::npos)
            << error.what();
      }
    }
}

TEST(FormulaLawTest, AMotionBeyondTheLargestPenetrationFails) {
  for (const std::string text : {"2e7*x^1.5", "1e5*x + 1e9*x^2.5"})
    EXPECT_THROW(run(formula(text, Tension::refused, 1e-4), "exact"), NumericalError) << text;
  EXPECT_THROW(run(formula("8e4*x", Tension::refused, 1e-4), "exact"), NumericalError);
}

TEST(FormulaLawTest, FaultsAtRestAndJumpsAreFound) {
  EXPECT_NE(formula("1e5*x - 1e8*x^2")->fault_at_rest(), "");
  EXPECT_EQ(formula("1e5*x - 1e8*x^2", Tension::refused, 0.9e-3)->fault_at_rest(), "");
  EXPECT_NE(formula("1e5*x*sqrt(1e-3 - x)")->fault_at_rest(), "");
  EXPECT_TRUE(formula("1e5*x + 2*v")->jumps());
  EXPECT_TRUE(formula("1e5*x + 2")->jumps());
  EXPECT_TRUE(formula("1/x")->jumps());
  EXPECT_FALSE(formula("1e5*x*(1 + v^2)")->jumps());
}

TEST(FormulaLawTest, AForceThatCannotBeCutOffIsRefused) {
  EXPECT_THROW(formula("2e7*x^1.5 + 400*x^0.25*v", Tension::cut_off), std::invalid_argument);
  EXPECT_THROW(formula("2e7*x^1.5*(1 + v^3)", Tension::cut_off), std::invalid_argument);
  EXPECT_THROW(formula("2e7*x^1.5", Tension::cut_off), std::invalid_argument);
}

} // namespace formula_law_tests
} // namespace vibroimpact::contact
