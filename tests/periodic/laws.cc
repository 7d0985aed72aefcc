// Periodic motions against a stop of every law: the motion repeats itself, and its derivative is
// that of differences of the motion.
#include "contact/laws/crushable_table.h"
#include "contact/laws/formula.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/table.h"
#include "contact/laws/tsuji.h"
#include "forced_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace laws_tests {

using testing::ForcedMap;
using testing::Oscillator;
using testing::oscillator;

struct Case {
  const char *name;
  std::shared_ptr<const contact::ContactLaw> law;
  double residual = 1e-11;
};

void PrintTo(const Case &shown, std::ostream *out) { *out << shown.name; }

class LawsTable : public ::testing::TestWithParam<Case> {};

Matrix differences(const StroboscopicMap &map, const Section &section, const Vector &state,
                   double h) {
  Matrix columns(state.size(), state.size());
  for (Index j = 0; j < state.size(); ++j) {
    const auto at = [&](double by) -> Vector {
      return map.carry(section.phase, section.phase + section.length(),
                       state + by * Vector::Unit(state.size(), j));
    };
    columns.col(j) = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
  }
  return columns;
}

TEST_P(LawsTable, repeats_itself_with_its_derivative) {
  Oscillator model = oscillator(1, 40, 0.8);
  model.push(3, 5);
  model.stop({{0.1, GetParam().law}});
  ForcedMap forced(model, false);
  Vector state = Vector::Zero(forced.map.size());
  state.tail(GetParam().law->n_internal()) = model.contacts.initial_internal();
  for (int period = 0; period < 40; ++period)
    state = forced.map.carry(0, 1, state);
  const Orbit orbit = find_orbit(forced.map, 1, state);
  EXPECT_GE(orbit.point.image.pattern.events.size(), 1u);
  EXPECT_EQ(orbit.point.image.without_derivative, 0);
  EXPECT_LT(orbit.point.residual, GetParam().residual);
  const Vector again =
      forced.map.carry(orbit.section.phase, orbit.section.phase + 1, orbit.point.state);
  EXPECT_LT((again - orbit.point.state).norm(), 1e-9);
  const Matrix expected = differences(forced.map, orbit.section, orbit.point.state, 1e-5);
  EXPECT_LT((orbit.point.image.by_state - expected).norm(), 1e-5 * expected.norm())
      << orbit.point.image.by_state << "\n"
      << expected;
}

std::shared_ptr<const contact::ContactLaw> comes_back() {
  return std::make_shared<contact::CrushableTable>(
      contact::CrushCurves(contact::ForceCurve({0, 2e-3, 2e-2}, {0, 8, 40}),
                           contact::ForceCurve({0, 4e-3, 2e-2}, {0, 4, 24}), 8000));
}

std::shared_ptr<const contact::ContactLaw> formula(const std::string &text) {
  return std::make_shared<contact::FormulaLaw>(parameters::Formula(text, {}, {"x", "v"}), 1,
                                               contact::Tension::refused);
}

INSTANTIATE_TEST_SUITE_P(
    LawsOfContacts, LawsTable,
    ::testing::Values(
        Case{"linear penalty", std::make_shared<contact::LinearPenalty>(4000)},
        Case{"Kelvin-Voigt", std::make_shared<contact::KelvinVoigt>(4000, 20)},
        Case{"kelvin-voigt bumper", std::make_shared<contact::KelvinVoigtBumper>(4000, 60)},
        Case{"bilinear stop", std::make_shared<contact::BilinearStop>(4000, 20)},
        Case{"Hertz", std::make_shared<contact::Hertz>(contact::HertzConstants{.stiffness = 4e4}),
             1e-9},
        Case{"Hunt-Crossley",
             contact::HuntCrossley::with_dimensionless_damping({.stiffness = 4e4, .exponent = 1.5},
                                                               0.4, 1e-9),
             1e-9},
        Case{"table",
             std::make_shared<contact::Table>(contact::ForceCurve({0, 2e-3, 1e-2}, {0, 6, 60}), 20,
                                              false)},
        Case{"table that comes back", comes_back()},
        Case{"formula", formula("4e4*x^1.5*(1 + 0.4*v)"), 1e-9},
        Case{"formula in steps", formula("3e3*x + 4e4*x^1.5*(1 + 0.4*v^2)"), 1e-9},
        Case{"Kuwabara-Kono", std::make_shared<contact::KuwabaraKono>(4e4, 1e-3), 1e-9},
        Case{"Tsuji", std::make_shared<contact::Tsuji>(4e4, 40), 1e-9},
        Case{"Newton's restitution", testing::newton(0.7)}));

} // namespace laws_tests
} // namespace vibroimpact::periodic
