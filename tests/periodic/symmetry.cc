// Which models are symmetric, and what the half-period map of those says.
#include "periodic/symmetry.h"

#include "contact/laws/kelvin_voigt_bumper.h"
#include "forced_models.h"
#include "model/piecewise_function.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace symmetry_tests {

using contact::BilinearStop;
using contact::KelvinVoigtBumper;
using testing::ForcedMap;
using testing::isolator;
using testing::Oscillator;
using testing::oscillator;
using testing::vector_of;

bool has_symmetry(const Oscillator &model) { return ForcedMap(model).map.symmetric(); }

Oscillator between_stops(double right, double left, double stiffness, double other_stiffness) {
  Oscillator model = oscillator(1, 1, 0.02);
  model.push(0.52, 1.3);
  model.stop({{right, std::make_shared<BilinearStop>(stiffness, 0.4)}},
             {{left, std::make_shared<BilinearStop>(other_stiffness, 0.4)}});
  return model;
}

TEST(SymmetryTest, EqualStopsOnBothSides) {
  EXPECT_TRUE(has_symmetry(between_stops(1, 1, 2, 2)));
  EXPECT_FALSE(has_symmetry(between_stops(1, 1.001, 2, 2)));
  EXPECT_FALSE(has_symmetry(between_stops(1, 1, 2, 2.001)));
  Oscillator one_sided = oscillator(1, 1, 0.02);
  one_sided.push(0.52, 1.3);
  EXPECT_TRUE(has_symmetry(one_sided));
  one_sided.stop({{1, std::make_shared<BilinearStop>(2, 0.4)}});
  EXPECT_FALSE(has_symmetry(one_sided));
}

// Stops that stand still beside a base that moves are symmetric when they do so on both sides.
TEST(SymmetryTest, StopsThatMoveAgainstTheBase) {
  for (const bool both : {true, false}) {
    Oscillator shaken = oscillator(1, 1, 0.02);
    shaken.model.add_base_motion(
        "shake", std::make_shared<model::Harmonic>(model::Given::displacement, 0.4, 1.3, 0), {0},
        Vector3::UnitX());
    const auto law = std::make_shared<BilinearStop>(2, 0.4);
    shaken.stop({{1, law}}, {{1, law}});
    std::vector<contact::ContactPair> pairs = shaken.contacts.pairs();
    ASSERT_NE(pairs[0].gap.base_coefficients.at(0), 0);
    if (!both)
      pairs[1].gap.base_coefficients[0] = 0;
    shaken.contacts = contact::ContactSet(std::move(pairs));
    EXPECT_EQ(has_symmetry(shaken), both);
  }
}

TEST(SymmetryTest, OddForcing) {
  Oscillator forced = isolator(1.3);
  forced.push(0.1, 3 * 1.3, 0.2);
  EXPECT_TRUE(has_symmetry(forced));
  Oscillator even = isolator(1.3);
  even.push(0.1, 2 * 1.3);
  EXPECT_FALSE(has_symmetry(even));
  Oscillator loaded = isolator(1.3);
  loaded.model.add_force("weight", model::make_constant(model::Given::displacement, 0.01), {},
                         Vector3::UnitX());
  EXPECT_FALSE(has_symmetry(loaded));
}

// The stops exchange their deformations.
TEST(SymmetryTest, HalfMapTwiceIsTheMapOfThePeriod) {
  Oscillator bumpers = oscillator(1, 1, 0.2);
  bumpers.push(1, 1.2);
  const auto law = std::make_shared<KelvinVoigtBumper>(1.0, 1.0);
  bumpers.stop({{0.4, law}}, {{0.4, law}});
  ForcedMap forced(bumpers);
  ASSERT_TRUE(forced.map.symmetric());
  const Vector state = vector_of({-0.1, 0.9, 0.02, 0.15});
  const Section half{.phase = 0.13, .halves = 1}, whole{.phase = 0.13, .halves = 2};
  const Flow once = forced.map.image(half, state);
  const Flow twice = forced.map.image(half, once.state);
  const Flow direct = forced.map.image(whole, state);
  EXPECT_GE(direct.pattern.events.size(), 4u);
  EXPECT_LT((twice.state - direct.state).norm(), 1e-11);
  EXPECT_LT((twice.by_state * once.by_state - direct.by_state).norm(), 1e-9);
}

// Two oscillators on one spring, pushed with the phases 0 and `phase`.
Oscillator pair_of(double second_mass, double phase) {
  Oscillator pair{.model = model::Model({testing::single_mass("one", 1, 1, 0.1),
                                         testing::single_mass("two", second_mass, 1, 0.1)})};
  for (const auto &[head, lag] : {std::pair("one.head", 0.0), std::pair("two.head", phase)}) {
    model::PointReference at;
    pair.model.find_point(head, at);
    pair.model.add_force(
        head, std::make_shared<model::Harmonic>(model::Given::displacement, 0.8, 1.1, lag), at,
        Vector3::UnitX());
  }
  model::PointReference one, two;
  pair.model.find_point("one.head", one);
  pair.model.find_point("two.head", two);
  model::Projection elongation = pair.model.displacement(two, Vector3::UnitX(), false);
  elongation.row -= pair.model.displacement(one, Vector3::UnitX(), false).row;
  pair.model.add_connection({.name = "spring",
                             .side_a = "one.head",
                             .side_b = "two.head",
                             .elongation = elongation,
                             .stiffness = 0.3,
                             .damping = 0.02});
  return pair;
}

void put_walls(Oscillator &pair, double first, double second) {
  const auto law = std::make_shared<KelvinVoigtBumper>(1.0, 1.0);
  pair.contacts =
      contact::ContactSet({testing::contact_along_x(pair.model, "one.head", "", first, law),
                           testing::contact_along_x(pair.model, "two.head", "", second, law)});
}

void expect_half_map(const Oscillator &model, const Vector &state) {
  ForcedMap forced(model);
  ASSERT_TRUE(forced.map.symmetric());
  const Section half{.phase = 0.13, .halves = 1}, whole{.phase = 0.13, .halves = 2};
  const Flow once = forced.map.image(half, state);
  const Flow twice = forced.map.image(half, once.state);
  const Flow direct = forced.map.image(whole, state);
  EXPECT_GE(direct.pattern.events.size(), 2u);
  EXPECT_LT((twice.state - direct.state).norm(), 1e-11);
  EXPECT_LT((twice.by_state * once.by_state - direct.by_state).norm(), 1e-9);
}

// Each has a wall to its right, and does half a period later what the other does.
TEST(SymmetryTest, EqualBodiesThatExchangeTheirParts) {
  Oscillator pair = pair_of(1, std::numbers::pi);
  put_walls(pair, 0.4, 0.4);
  expect_half_map(pair, vector_of({-0.1, 0.2, 0.9, -0.4, 0.02, 0.15}));
  put_walls(pair, 0.4, 0.41);
  EXPECT_FALSE(has_symmetry(pair));
  Oscillator unequal = pair_of(1.001, std::numbers::pi), together = pair_of(1, 0);
  put_walls(unequal, 0.4, 0.4);
  put_walls(together, 0.4, 0.4);
  EXPECT_FALSE(has_symmetry(unequal));
  EXPECT_FALSE(has_symmetry(together));
}

// Pushed together they exchange their parts with the opposite sign: the contact between them is its
// own partner.
TEST(SymmetryTest, EqualBodiesThatStrikeEachOther) {
  const auto law = std::make_shared<KelvinVoigtBumper>(1.0, 1.0);
  for (const double phase : {0.0, 1.0}) {
    Oscillator pair = pair_of(1, phase);
    pair.contacts = contact::ContactSet(
        {testing::contact_along_x(pair.model, "one.head", "two.head", 0.2, law)});
    if (phase == 0)
      expect_half_map(pair, vector_of({0.3, -0.2, 0.9, -0.4, 0.02}));
    else
      EXPECT_FALSE(has_symmetry(pair));
  }
}

TEST(SymmetryTest, MultipliersOfAPeriodAreSquares) {
  const Oscillator model = isolator(1.3002392653669812);
  ForcedMap half(model), whole(model, false);
  const Vector start = vector_of({-0.41, -1.68});
  const Orbit one = find_orbit(half.map, 1, start), other = find_orbit(whole.map, 1, start);
  EXPECT_TRUE(one.symmetric());
  EXPECT_FALSE(other.symmetric());
  EXPECT_LT((one.multipliers(half.map) - other.multipliers(whole.map)).cwiseAbs().maxCoeff(),
            1e-10);
  EXPECT_LT((state_at_zero_phase(half.map, one) - state_at_zero_phase(whole.map, other)).norm(),
            1e-11);
}

} // namespace symmetry_tests
} // namespace vibroimpact::periodic
