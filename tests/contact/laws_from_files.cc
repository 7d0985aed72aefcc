// Every key of every law, read from a file: the force at a state, worked out by hand from the
// figures of the file.
#include "contact/laws.h"

#include "contact/restitution_relation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::contact {
namespace laws_from_files_tests {

std::shared_ptr<const ContactLaw> law_of(const std::string &name, const std::string &section,
                                         const std::string &keys) {
  const auto root = std::make_shared<parameters::Section>("", "");
  declare_contact_laws(*root);
  const std::string text =
      "set Law = " + name + "\nsubsection " + section + "\n" + keys + "\nend\n";
  return create_contact_law(parameters::ParameterSet::parse(root, text, "test.prm", false)->root());
}

// In contact at a penetration u [m] that grows at the rate v [m/s].
double force(const ContactLaw &law, double u, double v, const std::vector<double> &internal = {}) {
  LawResponse response;
  law.evaluate(1, {.gap = -u, .gap_rate = -v, .internal = internal}, response);
  return response.force;
}

constexpr double u = 1e-4, v = 0.3;
const std::string spring = "set Stiffness = 80 kN/m\n";
const std::string dashpot = "set Damping constant = 160 N s/m\n";
const std::string hertzian = "set Stiffness = 1e10 N/m^1.5\n";
constexpr double hertzian_force = 1e10 * 1e-6; // at u

TEST(LawsFromFilesTest, SpringsAndDashpots) {
  EXPECT_NEAR(force(*law_of("linear penalty", "Linear penalty", spring), u, v), 8, 1e-12);
  for (const auto &[name, section] : {std::pair{"kelvin-voigt", "Kelvin-Voigt"},
                                      std::pair{"kelvin-voigt bumper", "Kelvin-Voigt bumper"},
                                      std::pair{"bilinear stop", "Bilinear stop"}})
    EXPECT_NEAR(force(*law_of(name, section, spring + dashpot), u, v, {u}), 8 + 48, 1e-12) << name;
}

TEST(LawsFromFilesTest, HertzStiffnessAndExponent) {
  EXPECT_NEAR(force(*law_of("hertz", "Hertz", hertzian), u, v), hertzian_force, 1e-8);
  const auto steep = law_of("hertz", "Hertz", "set Stiffness = 1e10 N/m^2\nset Exponent = 2");
  EXPECT_NEAR(force(*steep, u, v), 1e10 * 1e-8, 1e-10);
}

// A sphere of 20 mm and 70 GPa against a flat side of 210 GPa:
// k = 4/3 sqrt(R) / ((1 - 0.2^2) / 70e9 + (1 - 0.3^2) / 210e9).
TEST(LawsFromFilesTest, HertzStiffnessOfEitherCurvedSide) {
  const double k = 4.0 / 3 * std::sqrt(0.02) / (0.96 / 70e9 + 0.91 / 210e9);
  const auto sides = [](const std::string &sphere, const std::string &plane) {
    return "set Radius " + sphere + " = 20 mm\nset Young modulus " + sphere +
           " = 70 GPa\nset Poisson ratio " + sphere + " = 0.2\nset Young modulus " + plane +
           " = 210 GPa\nset Poisson ratio " + plane + " = 0.3";
  };
  for (const std::string &keys : {sides("a", "b"), sides("b", "a")})
    EXPECT_NEAR(force(*law_of("hertz", "Hertz", keys), u, v) / (k * 1e-6), 1, 1e-13) << keys;
}

// F = k u^n + mu u^n u': mu has the unit of k times a time over a length.
TEST(LawsFromFilesTest, DampingFactorOfHuntCrossley) {
  const auto law =
      law_of("hunt-crossley", "Hunt-Crossley", hertzian + "set Damping factor = 4e9 N s/m^2.5");
  EXPECT_NEAR(force(*law, u, v), hertzian_force + 4e9 * 1e-6 * v, 1e-8);
  const auto steep = law_of("hunt-crossley", "Hunt-Crossley",
                            "set Stiffness = 1e10 N/m^2\nset Exponent = 2\n"
                            "set Damping factor = 4e9 N s/m^3");
  EXPECT_NEAR(force(*steep, u, v), (1e10 + 4e9 * v) * 1e-8, 1e-10);
}

// At the approach speed the damping adds d_c of the elastic force; a speed given stands for that of
// all impacts, and impacts slower than the lowest one are damped as if they had it.
TEST(LawsFromFilesTest, RestitutionOfHuntCrossley) {
  const std::string keys = hertzian + "set Restitution coefficient = 0.7\nset Relation = flores\n";
  const double damping = 8.0 / 5 * (1 - 0.7) / 0.7; // Flores et al. 2011
  const auto law = [&](const std::string &more) {
    return law_of("hunt-crossley", "Hunt-Crossley", keys + more);
  };
  EXPECT_NEAR(force(*law("set Approach speed = 0.5 m/s"), u, v),
              hertzian_force * (1 + damping * v / 0.5), 1e-8);
  const auto own = law("set Lowest approach speed = 10 mm/s");
  EXPECT_NEAR(force(*own, u, v, {0.6}), hertzian_force * (1 + damping * v / 0.6), 1e-8);
  EXPECT_NEAR(force(*own, u, v, {1e-3}), hertzian_force * (1 + damping * v / 0.01), 1e-8);
}

// alpha sqrt(m k) u^(1/4) u' with alpha = sqrt(5) ln(1/e) / sqrt(pi^2 + ln^2 e).
TEST(LawsFromFilesTest, TsujiDampingByCoefficientOrRestitution) {
  const std::string keys = hertzian + "set Effective mass = 2 kg\n";
  const double scale = std::sqrt(2 * 1e10) * 0.1 * v;
  EXPECT_NEAR(force(*law_of("tsuji", "Tsuji", keys + "set Damping coefficient = 0.2"), u, v),
              hertzian_force + 0.2 * scale, 1e-8);
  const double logarithm = std::log(0.8);
  const double alpha = -std::sqrt(5.0) * logarithm /
                       std::sqrt(std::numbers::pi * std::numbers::pi + logarithm * logarithm);
  EXPECT_NEAR(force(*law_of("tsuji", "Tsuji", keys + "set Restitution coefficient = 0.8"), u, v),
              hertzian_force + alpha * scale, 1e-8);
}

TEST(LawsFromFilesTest, DissipationTimeOfKuwabaraKono) {
  const auto law =
      law_of("kuwabara-kono", "Kuwabara-Kono", hertzian + "set Dissipation time = 2 us");
  EXPECT_NEAR(force(*law, u, v), hertzian_force + 2e-6 * 1.5e10 * 1e-2 * v, 1e-8);
}

TEST(LawsFromFilesTest, NewtonRestitution) {
  const auto law =
      law_of("newton restitution", "Newton restitution", "set Restitution coefficient = 0.35");
  EXPECT_EQ(law->restitution(2), 0.35);
}

} // namespace laws_from_files_tests
} // namespace vibroimpact::contact
