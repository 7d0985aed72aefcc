// Connections by a table or a formula: oscillators whose periods are known.
#include "contact/connection_laws.h"
#include "common/error.h"
#include "contact/laws/formula_spring.h"
#include "contact/laws/table_spring.h"
#include "model/connection.h"
#include "model/excitation.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "motion/system/equilibrium.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::contact {
namespace connection_laws_tests {

using namespace motion;
using model::Model;

std::shared_ptr<const ContactLaw> formula(const std::string &tension, double largest = 10) {
  return std::make_shared<FormulaSpring>(parameters::Formula(tension, {}, {"x", "v"}), largest);
}

struct Outcome {
  double place = 0, speed = 0;
  Accuracy accuracy;
};

// A mass of 1 kg between the connection and the spring of the body [N/m].
Outcome run(const Model &model, const std::shared_ptr<const ContactLaw> &law, double place,
            double speed, double duration, const std::string &method = "exact") {
  std::vector<ContactPair> pairs;
  if (law)
    pairs.push_back(testing::contact_along_x(model, "block.head", "", 0, law));
  const ContactSet contacts(pairs);
  Settings settings;
  settings.method = method;
  settings.relative_tolerance = 1e-13;
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(0, Vector::Constant(1, place), Vector::Constant(1, speed));
  ImpactLog log(contacts, 0);
  trajectory.advance(duration, log);
  return {trajectory.state()[0], trajectory.state()[1], trajectory.accuracy()};
}

Model oscillator(double spring, double damping = 0) {
  return Model({testing::single_mass("block", 1, spring, damping)});
}

// x'' + x + g x^3 = 0 from rest at A: W = pi sqrt(1 + g A^2) / (2 K(m)), m = g A^2 / (2 (1 + g
// A^2)).
TEST(ConnectionLawsTest, PeriodOfDuffingsOscillator) {
  struct Case {
    double cubic, amplitude, frequency;
  };
  for (const Case &duffing : {Case{0.1, 1, 1.0367169070746},
                              {0.1, 2, 1.1389077384382},
                              {0.1, 3, 1.2898105301685},
                              {1, 1, 1.3177760649655},
                              {0.5, 2, 1.5691058028693}}) {
    const double modulus = duffing.cubic * duffing.amplitude * duffing.amplitude;
    const double period = 2 * std::numbers::pi / duffing.frequency;
    EXPECT_NEAR(duffing.frequency,
                std::numbers::pi * std::sqrt(1 + modulus) /
                    (2 * std::comp_ellint_1(std::sqrt(modulus / (2 * (1 + modulus))))),
                2e-13);
    const Outcome out = run(oscillator(1), formula(std::to_string(duffing.cubic) + "*x^3"),
                            duffing.amplitude, 0, period);
    EXPECT_NEAR(out.place, duffing.amplitude, 1e-11) << duffing.cubic << duffing.amplitude;
    EXPECT_NEAR(out.speed, 0, 1e-11) << duffing.cubic << duffing.amplitude;
    EXPECT_LT(out.accuracy.energy_residual, 1e-11);
  }
}

TEST(ConnectionLawsTest, ACubicFormulaIsTheCubicStiffness) {
  Model cubic = oscillator(30, 0.2);
  model::PointReference head;
  cubic.find_point("block.head", head);
  model::Projection elongation = cubic.displacement(head, Vector3::UnitX(), true);
  elongation.row *= -1;
  cubic.add_connection({.name = "link",
                        .side_a = "block.head",
                        .side_b = "ground",
                        .elongation = elongation,
                        .stiffness = 2,
                        .cubic_stiffness = 5,
                        .damping = 0.1});
  const Outcome known = run(cubic, nullptr, 0.7, 0.4, 5);
  const Outcome written = run(oscillator(30, 0.2), formula("2*x + 5*x^3 + 0.1*v"), 0.7, 0.4, 5);
  EXPECT_NEAR(written.place, known.place, 1e-12);
  EXPECT_NEAR(written.speed, known.speed, 1e-12);
}

// Between two springs [N/m] with the free play 2 d: two quarters of a sine on each side.
TEST(ConnectionLawsTest, PeriodWithFreePlay) {
  const double play = 2e-3, stiffness = 400, speed = 0.1;
  const auto law = std::make_shared<TableSpring>(
      ForceCurve({-1, -play, play, 1}, {-stiffness * (1 - play), 0, 0, stiffness * (1 - play)}));
  const double period = 4 * play / speed + 2 * std::numbers::pi / std::sqrt(stiffness);
  for (const std::string method : {"exact", "rk"}) {
    const double accuracy = method == "exact" ? 1e-14 : 1e-10; // located on a polynomial of order 6
    const Outcome out = run(oscillator(0), law, 0, speed, 10 * period, method);
    EXPECT_NEAR(out.place, 0, accuracy) << method;
    EXPECT_NEAR(out.speed, speed, 10 * accuracy) << method;
    EXPECT_LT(out.accuracy.energy_residual, method == "exact" ? 1e-12 : 1e-8);
  }
}

// Whichever way the load points.
TEST(ConnectionLawsTest, AtRestTheTensionsBalanceTheLoad) {
  const auto play =
      std::make_shared<TableSpring>(ForceCurve({-0.3, -0.1, 0.1, 0.3}, {-4, 0, 0, 8}));
  const Model model = oscillator(30);
  for (const double place : {0.25, -0.25, 0.05, -0.05}) {
    // The elongation is that of a connection to the ground, -x.
    const double cubic = 2 * place + 5 * place * place * place;
    const double slack = std::abs(place) < 0.1 ? 0
                         : place > 0           ? 20 * (place - 0.1)
                                               : 40 * (place + 0.1);
    for (const auto &[law, force] : {std::pair{formula("2*x + 5*x^3"), cubic},
                                     {std::shared_ptr<const ContactLaw>(play), slack}}) {
      const ContactSet contacts({testing::contact_along_x(model, "block.head", "", 0, law)});
      const Vector load = Vector::Constant(1, 30 * place + force);
      EXPECT_NEAR(static_equilibrium(model, contacts, load).displacement[0], place, 1e-14) << place;
    }
  }
}

TEST(ConnectionLawsTest, OneLineIsASpring) {
  const auto table = std::make_shared<TableSpring>(ForceCurve({-1, 0.1, 2}, {-7, 0.7, 14}));
  const Outcome known = run(oscillator(10), nullptr, 0.3, 0.2, 40);
  for (const auto &law : {std::shared_ptr<const ContactLaw>(table), formula("7*x")}) {
    const Outcome out = run(oscillator(3), law, 0.3, 0.2, 40);
    EXPECT_NEAR(out.place, known.place, 1e-12);
    EXPECT_NEAR(out.speed, known.speed, 1e-12);
  }
}

TEST(ConnectionLawsTest, DerivativesPowerAndAffineForm) {
  const TableSpring table(ForceCurve({-2e-3, -1e-3, 5e-4, 2e-3}, {-90, -20, 10, 40}));
  for (int mode = 0; mode < static_cast<int>(table.modes().size()); ++mode)
    for (const double gap : {-1.3e-3, 7e-4})
      testing::check_law(table, {.mode = mode, .gap = gap, .gap_rate = 0.2});
  for (const std::string text :
       {"300*x", "2e4*x + 30*v", "1e4*x + 1e10*x^3 + 20*v*abs(v)", "50*tanh(x/1e-3)*(1 + v^2)"})
    for (const double gap : {-1.3e-3, 7e-4})
      testing::check_law(*formula(text, 5e-3), {.mode = 0, .gap = gap, .gap_rate = 0.2});
  EXPECT_TRUE(table.always_in_contact());
  EXPECT_TRUE(formula("x^3")->always_in_contact());
}

// The connection pulls with what the file says.
TEST(ConnectionLawsTest, ATableAndAFormulaFromAFile) {
  const auto root = std::make_shared<parameters::Section>("", "");
  model::declare_connections(*root);
  model::declare_excitations(*root); // which may move the ground behind a connection
  declare_connection_laws(*root);
  const auto set = parameters::ParameterSet::parse(
      root,
      "set Variables = k = 3 kN/m, k3 = 2e9 N/m^3\n"
      "subsection Connection play\nset Between = block.head\nset Law = table\nsubsection Table\n"
      "set Elongation = -3 mm, -1 mm, 1 mm, 2 mm\nset Tension = -8 N, 0 N, 0 N, 5 N\nend\nend\n"
      "subsection Connection hard\nset Between = block.head, ground\nset Direction = -x\n"
      "set Law = formula\nsubsection Formula\nset Tension = k*x + k3*x^3\n"
      "set Largest elongation = 5 mm\nend\nend\n"
      "subsection Connection plain\nset Between = block.head\nset Stiffness = 1 N/m\nend\n",
      "test.prm", false);
  const Model model({testing::single_mass("block", 1, 1, 0)});
  const ContactSet contacts = with_connections(set->root(), model, {});
  ASSERT_EQ(contacts.size(), 2u);
  const ContactPair &play = contacts.pairs()[0], &hard = contacts.pairs()[1];
  EXPECT_EQ(play.name, "play");
  EXPECT_EQ(play.gap.row[0], -1);
  EXPECT_EQ(hard.gap.row[0], 1);
  const auto tension = [](const ContactPair &pair, double elongation) {
    LawResponse response;
    const LocalState state{.gap = elongation};
    pair.law->evaluate(pair.law->initial_mode(state), state, response);
    return -response.force;
  };
  for (const auto &[elongation, expected] :
       {std::pair{-4e-3, -12.0}, {-2e-3, -4.0}, {0.3e-3, 0.0}, {1.6e-3, 3.0}, {4e-3, 15.0}})
    EXPECT_NEAR(tension(play, elongation), expected, 1e-12);
  EXPECT_NEAR(tension(hard, 2e-3), 6 + 16, 1e-12);
}

TEST(ConnectionLawsTest, AMotionBeyondTheLargestElongationFails) {
  for (const double speed : {1.0, -1.0})
    EXPECT_THROW(run(oscillator(1), formula("x^3", 0.5), 0, speed, 5), NumericalError);
}

} // namespace connection_laws_tests
} // namespace vibroimpact::contact
