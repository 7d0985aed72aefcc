// Motions with nonlinear contacts and springs by the whole program against their references in long
// double: never more than ten times the tolerance, times what the motion itself makes of a small
// error.
#include "support/random_contact.h"
#include "support/reference_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::testing {
namespace nonlinear_contacts_tests {

constexpr double quarter_turn = std::numbers::pi / 2; // of a source that is constant

struct ReferenceCase {
  ReferenceSystem system;
  ReferenceStart start;
  double end = 0;
};

void expect_agreement(const std::string &name, const ReferenceCase &tried,
                      const ReferenceResult &reference) {
  const double growth = amplification(tried.system, tried.start, tried.end);
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    const ProgramMotion motion = program_motion(tried.system, tried.start, tried.end, tolerance);
    const MotionError error = compare(motion, tried.system, reference);
    EXPECT_TRUE(error.same_contacts) << name << " at " << tolerance;
    EXPECT_LE(error.state, 10 * tolerance * growth) << name << " at " << tolerance;
    EXPECT_TRUE(motion.accuracy.balanced()) << name << " at " << tolerance;
  }
}

ReferenceResult check(const std::string &name, const ReferenceCase &tried) {
  ReferenceResult reference = reference_motion(tried.system, tried.start, tried.end);
  expect_agreement(name, tried, reference);
  return reference;
}

ReferenceCase two_spheres(const ReferenceLaw &law) {
  return {.system = {.mass = {1, 2.5},
                     .stiffness = {0, 0},
                     .damping = {0, 0},
                     .contacts = {{.row = {-1, 1}, .clearance = 1e-3, .law = law}}},
          .start = {{0, 0}, {0.3, -0.2}},
          .end = 0.3};
}

// A single contact: its instants and impulses too.
void check_spheres(const std::string &name, const ReferenceLaw &law) {
  const ReferenceCase tried = two_spheres(law);
  const ReferenceResult reference = check(name, tried);
  ASSERT_EQ(reference.impacts[0].size(), 1u) << name;
  for (const double tolerance : {1e-4, 1e-7, 1e-10, 1e-12}) {
    const ProgramMotion motion = program_motion(tried.system, tried.start, tried.end, tolerance);
    const MotionError error = compare(motion, tried.system, reference);
    ASSERT_TRUE(error.same_contacts) << name;
    EXPECT_LE(error.instant, 10 * tolerance) << name << " at " << tolerance;
    EXPECT_LE(error.impulse, 10 * tolerance) << name << " at " << tolerance;
    EXPECT_LE(error.energy, 10 * tolerance) << name << " at " << tolerance;
  }
}

TEST(NonlinearContactsTest, TwoFreeSpheres) {
  for (const double exponent : {1.5, 2.2, 3.0})
    check_spheres("n = " + std::to_string(exponent), {.stiffness = 1e7, .exponent = exponent});
}

// d v = 0.1 ... 10 at 0.5 m/s: restitution from 0.9 to 0.1.
TEST(NonlinearContactsTest, HuntCrossley) {
  for (const double exponent : {1.5, 2.2})
    for (const double dissipation : {0.2, 1.0, 5.0, 20.0})
      check_spheres("d = " + std::to_string(dissipation),
                    {.stiffness = 1e7, .exponent = exponent, .damping = dissipation});
}

TEST(NonlinearContactsTest, KuwabaraKonoAndTsuji) {
  check_spheres("Kuwabara-Kono",
                {.kind = ReferenceLaw::Kind::kuwabara_kono, .stiffness = 1e7, .damping = 1e-4});
  check_spheres("Tsuji", {.kind = ReferenceLaw::Kind::tsuji, .stiffness = 1e7, .damping = 500});
}

// A mass behind a light tip on a spring that meets a stop.
ReferenceCase sprung_tip(double tip, double spring, double clearance, double tip_speed,
                         const ReferenceLaw &law) {
  return {.system = {.mass = {1, tip},
                     .stiffness = {0, 0},
                     .damping = {0, 0},
                     .contacts = {{.row = {0, -1}, .clearance = clearance, .law = law}},
                     .springs = {{.row = {-1, 1}, .stiffness = spring}}},
          .start = {{0, 0}, {0.5, tip_speed}},
          .end = 0.06};
}

TEST(NonlinearContactsTest, SubImpacts) {
  const ReferenceResult reference =
      check("sub-impacts", sprung_tip(0.02, 1e4, 1e-3, 0.5, {.stiffness = 1e9, .damping = 0.1}));
  EXPECT_GE(reference.impacts[0].size(), 16u);
}

// The tip vibrates nearly as fast as the mass approaches: without parting from the soft stop.
TEST(NonlinearContactsTest, OneContactOfManyHumps) {
  for (const double damping : {0.0, 0.1}) {
    const ReferenceResult reference =
        check("humps", sprung_tip(0.05, 1.3e6, 1e-9, 0.95, {.stiffness = 1e6, .damping = damping}));
    ASSERT_EQ(reference.impacts[0].size(), 1u);
    EXPECT_GE(reference.impacts[0][0].humps, damping > 0 ? 3 : 8);
  }
}

// Bounces of a pressed mass, rest on the stop, and a release when the force turns.
TEST(NonlinearContactsTest, BouncesAndALongPressedContact) {
  const ReferenceResult reference =
      check("pressed", {.system = {.mass = {1},
                                   .stiffness = {0},
                                   .damping = {0},
                                   .contacts = {{.row = {-1},
                                                 .clearance = 1e-2,
                                                 .law = {.stiffness = 1e7, .damping = 3}}},
                                   .forces = {ReferenceHarmonic{50, 2, quarter_turn}}},
                        .start = {{0}, {0}},
                        .end = 1.3});
  ASSERT_GE(reference.impacts[0].size(), 2u);
  EXPECT_GT(reference.impacts[0].back().duration, 0.5L);
}

// Shallow touches at 5 mm/s to 4 um/s, pressed on by a load.
TEST(NonlinearContactsTest, SlowTouches) {
  for (const double speed : {5e-3, 1e-4, 4e-6})
    check("at " + std::to_string(speed),
          {.system = {.mass = {1},
                      .stiffness = {0},
                      .damping = {0},
                      .contacts = {{.row = {-1},
                                    .clearance = 1e-6,
                                    .law = {.stiffness = 1e8, .damping = 1}}},
                      .forces = {ReferenceHarmonic{1, 0, quarter_turn}}},
           .start = {{0}, {speed}},
           .end = 0.03});
}

TEST(NonlinearContactsTest, Exponents) {
  const double exponents[] = {1.1, 2.2, 3.0}, stiffnesses[] = {1e6, 1e9, 1e12};
  for (int i = 0; i < 3; ++i) {
    const ReferenceResult reference =
        check("n = " + std::to_string(exponents[i]),
              {.system = {.mass = {1},
                          .stiffness = {0},
                          .damping = {0},
                          .contacts = {{.row = {-1},
                                        .clearance = 1e-2,
                                        .law = {.stiffness = stiffnesses[i],
                                                .exponent = exponents[i],
                                                .damping = 0.6}}},
                          .forces = {ReferenceHarmonic{9.81, 0, quarter_turn}}},
               .start = {{0}, {0.5}},
               .end = 0.7});
    EXPECT_GE(reference.impacts[0].size(), 5u);
  }
}

// Two contacts on one body, the second begins while the first has hardly any force.
TEST(NonlinearContactsTest, TwoContactsBegunCloseTogether) {
  for (const double apart : {1e-7, 1e-5, 1e-4}) {
    const ReferenceResult reference = check(
        "apart by " + std::to_string(apart),
        {.system = {.mass = {1, 0.05},
                    .stiffness = {0, 0},
                    .damping = {0, 0},
                    .contacts = {{.row = {-1, -0.1}, .clearance = 1e-3, .law = {.stiffness = 1e8}},
                                 {.row = {-1, 0.13},
                                  .clearance = 1e-3 + apart,
                                  .law = {.stiffness = 1e8, .damping = 0.5}}},
                    .one_body = true},
         .start = {{0, 0}, {0.5, 0}},
         .end = 0.02});
    ASSERT_EQ(reference.impacts[0].size(), 1u);
    ASSERT_EQ(reference.impacts[1].size(), 1u);
    EXPECT_LT(reference.impacts[1][0].start,
              reference.impacts[0][0].start + reference.impacts[0][0].duration);
  }
}

TEST(NonlinearContactsTest, MovingBase) {
  const ReferenceResult reference =
      check("base", {.system = {.mass = {1, 2},
                                .stiffness = {40, 0},
                                .damping = {0.5, 0.3},
                                .contacts = {{.row = {-1, 0},
                                              .clearance = 0.01,
                                              .law = {.stiffness = 1e7, .damping = 0.2},
                                              .by_base = -1},
                                             {.row = {1, -1},
                                              .clearance = 0.01,
                                              .law = {.stiffness = 1e7, .exponent = 2.2}}},
                                .springs = {{.row = {-1, 1}, .stiffness = 30, .damping = 0.2}},
                                .base = ReferenceHarmonic{0.02, 9, 0.3}},
                     .start = {{0, 0}, {0, 0}},
                     .end = 1.5});
  EXPECT_GE(reference.impacts[0].size(), 1u);
  EXPECT_GE(reference.impacts[1].size(), 1u);
}

ReferenceCase duffing(std::vector<ReferenceContact> contacts) {
  return {.system = {.mass = {1},
                     .stiffness = {1},
                     .damping = {0.05},
                     .contacts = std::move(contacts),
                     .springs = {{.row = {1}, .cubic = 1}},
                     .forces = {ReferenceHarmonic{0.5, 1.2, 0}}},
          .start = {{0.1}, {0}},
          .end = 30};
}

TEST(NonlinearContactsTest, Duffing) { check("Duffing", duffing({})); }

TEST(NonlinearContactsTest, CubicSpringWithAStop) {
  const ReferenceResult reference =
      check("cubic spring and stop",
            duffing({{.row = {-1}, .clearance = 0.5, .law = {.stiffness = 1e5}}}));
  EXPECT_GE(reference.impacts[0].size(), 3u);
}

TEST(NonlinearContactsTest, RandomContacts) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const RandomContact tried = random_contact(seed);
    const MotionError error =
        compare(program_motion(tried.system, tried.start, tried.end, tried.tolerance), tried.system,
                reference_motion(tried.system, tried.start, tried.end));
    EXPECT_TRUE(error.same_contacts) << "seed " << seed;
    EXPECT_LE(error.largest(), 10 * tried.tolerance) << "seed " << seed;
  }
}

} // namespace nonlinear_contacts_tests
} // namespace vibroimpact::testing
