// Where a periodic motion is cut: patterns, phases, and derivatives that move with the phase.
#include "periodic/orbit.h"

#include "forced_models.h"

#include <gtest/gtest.h>

namespace vibroimpact::periodic {
namespace sections_tests {

using testing::ForcedMap;
using testing::isolator;
using testing::Oscillator;
using testing::vector_of;

EventPattern pattern_of(std::vector<double> times, std::vector<char> touches_after, double length) {
  EventPattern pattern{
      .modes = {0}, .events = {}, .touches_after = std::move(touches_after), .length = length};
  for (const double time : times)
    pattern.events.push_back({.time = time});
  return pattern;
}

TEST(SectionsTest, CalmestInstantIsInTheMiddleOfTheLongestStay) {
  // 0.1 to 0.5 in contact, 0.5 to 0.8 free, 0.8 to 1.1 in contact
  const EventPattern pattern = pattern_of({0.1, 0.5, 0.8}, {1, 0, 1}, 1);
  EXPECT_NEAR(pattern.calmest_instant(), 0.65, 1e-15);
  EXPECT_NEAR(pattern.nearest_event(), 0.1, 1e-15);
  // The longest one goes across the end.
  EXPECT_NEAR(pattern_of({0.2, 0.4}, {1, 0}, 1).calmest_instant(), 0.8, 1e-15);
  EXPECT_NEAR(pattern_of({0.4, 0.9}, {0, 0}, 1).calmest_instant(), 0.65, 1e-15);
  EXPECT_NEAR(pattern_of({0.7, 0.9}, {1, 0}, 1).calmest_instant(), 0.3, 1e-15);
  EXPECT_EQ(pattern_of({}, {}, 1).calmest_instant(), 0);
  EXPECT_EQ(pattern_of({}, {}, 2).nearest_event(), 2);
}

TEST(SectionsTest, MultipliersAreTheSameFromEveryPhase) {
  const Oscillator model = isolator(1.3002392653669812);
  ForcedMap forced(model);
  const Orbit orbit = find_orbit(forced.map, 1, vector_of({-0.41, -1.68}));
  EXPECT_GE(orbit.point.image.pattern.nearest_event(), 0.08 * forced.map.period());
  const Eigen::VectorXcd expected = orbit.multipliers(forced.map);
  for (const double shift : {0.11, 0.27, 0.43, 0.61}) {
    Section section = orbit.section;
    const Vector moved = forced.map.carry(section.phase, section.phase + shift, orbit.point.state);
    section.phase += shift;
    const Orbit same{.section = section,
                     .point = {.state = moved, .image = forced.map.image(section, moved)}};
    EXPECT_LT((same.point.image.state - moved).norm(), 1e-10) << shift;
    EXPECT_LT((same.multipliers(forced.map) - expected).cwiseAbs().maxCoeff(), 1e-8) << shift;
  }
}

// The frequency moves both ends of the motion, whose phases stay.
TEST(SectionsTest, DerivativeByTheFrequencyMovesBothEnds) {
  const double lambda = 1.3002392653669812, phase = 0.37;
  const Vector state = vector_of({-0.3, -1.5});
  const auto image = [&](std::vector<ForcedKey *> keys, ForcedMap &forced) {
    forced.map.set_keys(std::move(keys));
    return forced.map.image({.phase = phase, .halves = 3}, state);
  };
  const Oscillator model = isolator(lambda);
  ForcedMap forced(model);
  std::vector<motion::KeyNeighbour> neighbours;
  for (const double offset : {-2e-3, -1e-3, 1e-3, 2e-3}) {
    Oscillator near = isolator(lambda + offset);
    neighbours.push_back(
        motion::KeyNeighbour::of(offset, std::move(near.model), std::move(near.contacts)));
  }
  ForcedKey key = forced_key("frequency", forced.system, std::move(neighbours));
  EXPECT_NEAR(key.period, -2 * std::numbers::pi / (lambda * lambda), 1e-10);
  const Flow exact = image({&key}, forced);
  EXPECT_GE(exact.pattern.events.size(), 3u);
  const auto at = [&](double by) {
    const Oscillator other = isolator(lambda + by);
    ForcedMap moved(other);
    return image({}, moved).state;
  };
  const double h = 1e-3;
  const Vector difference = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
  EXPECT_LT((exact.by_keys - difference).norm(), 1e-7 * difference.norm());
}

} // namespace sections_tests
} // namespace vibroimpact::periodic
