// Motions with friction whose figures others have published, or that were computed for their models
// by other means: chains with joints, springs and stops, a capsule that drives itself, a pressed
// block.
#include "contact/friction/spring_slider.h"
#include "contact/laws/linear_penalty.h"
#include "model/piecewise_function.h"
#include "support/friction_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace friction_published_tests {

using namespace model;
using contact::ContactSet;
using contact::LinearPenalty;
using contact::SpringSlider;
using testing::Changes;
using testing::constant_with;
using testing::contact_along_x;
using testing::coulomb;
using testing::settings_of;
using testing::single_mass;
using testing::sliding_along_x;
using testing::vector_of;

constexpr double pi = std::numbers::pi;

/// Between coordinates of one mass each; from = -1: from the ground.
struct Spring {
  Index from, to;
  double stiffness, damping, cubic;
};

void add_spring(Model &model, const Spring &spring) {
  RowVector row = RowVector::Zero(model.size());
  row[spring.to] = 1;
  if (spring.from >= 0)
    row[spring.from] = -1;
  model.add_connection({.name = "spring",
                        .side_a = "",
                        .side_b = "",
                        .elongation = {.row = row, .base_coefficients = {0}},
                        .stiffness = spring.stiffness,
                        .cubic_stiffness = spring.cubic,
                        .damping = spring.damping});
}

// A block of 7000 kg pressed by 2e5 N over a rough floor against a spring (code_aster, SDNV104b).
TEST(FrictionPublished, BlockPressedOverAFloor) {
  const double m = 7000, k = 24000, most = 0.3 * 70000, force = 2e5;
  Model model({single_mass("block", m, k, 0)});
  model.add_force("press", make_constant(Given::displacement, force), {.body = 0, .point = 0},
                  Vector3::UnitX());
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(70000, 0.3, 0.3))});
  Trajectory trajectory(model, contacts, settings_of("exact"));
  Changes changes(contacts);
  trajectory.start(0, vector_of({0}), vector_of({0}));
  trajectory.advance(5.5, changes);
  const double half = pi * std::sqrt(m / k);
  const double turns[] = {2 * (force - most) / k, 4 * most / k,
                          2 * (force - most) / k - 4 * most / k};
  ASSERT_EQ(changes.list.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(changes.list[i].time, static_cast<double>(i + 1) * half, 1e-12) << i;
    EXPECT_NEAR(changes.list[i].state[0], turns[i], 1e-12) << i;
  }
}

struct Capsule {
  double drive, mass, frequency;
  std::vector<double> ways; ///< in a period, or in each of several
};

// A mass in a capsule, on a spring and a dashpot, that is driven and meets a spring; the capsule
// rubs on the ground (Liu et al. 2013). Ways of the capsule in a period, by other means: 1.094851,
// .568740, 1.496897 and .889893, .125349 are known.
TEST(FrictionPublished, CapsuleThatDrivesItself) {
  const Capsule capsules[] = {{1.6, 5, 0.95, {1.094851234}},
                              {1.0, 5, 0.95, {.568739664}},
                              {1.6, 3, 0.95, {1.496900132}},
                              {1.6, 5, 1.1, {.889891921413, .125349569392}}};
  for (const Capsule &of : capsules) {
    Model model({single_mass("inner", 1, 0, 0), single_mass("capsule", of.mass, 0, 0)});
    add_spring(model, {.from = 0, .to = 1, .stiffness = 1, .damping = 0.1, .cubic = 0});
    model.add_force("drive",
                    std::make_shared<Harmonic>(Given::displacement, of.drive, of.frequency, pi / 2),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    const ContactSet contacts({contact_along_x(model, "inner.head", "capsule.head", 0.02,
                                               std::make_shared<LinearPenalty>(15)),
                               sliding_along_x(model, "capsule.head", "", coulomb(1, 1, 1))});
    Trajectory trajectory(model, contacts, settings_of("exact"));
    trajectory.start(0, vector_of({0, 0}), vector_of({0, 0}));
    const double period = 2 * pi / of.frequency;
    trajectory.advance(400 * period);
    std::vector<double> ways;
    for (std::size_t i = 0; i < of.ways.size(); ++i) {
      const double before = trajectory.state()[1];
      trajectory.advance((401 + static_cast<double>(i)) * period);
      ways.push_back(trajectory.state()[1] - before);
    }
    std::sort(ways.rbegin(), ways.rend());
    for (std::size_t i = 0; i < ways.size(); ++i)
      EXPECT_NEAR(ways[i], of.ways[i], 1e-9) << of.drive << ", " << of.mass;
  }
}

struct Statistics {
  double mean = 0, deviation = 0, largest = 0;
};

struct Chain {
  double frequency;
  std::array<Statistics, 3> known; ///< of q1, q2, q3
};

// Three masses with joints that slide, cubic springs and a stop (NLvib, example 07).
TEST(FrictionPublished, ChainWithJointsCubicSpringsAndAStop) {
  const Chain chains[] = {
      {1.2,
       {{{-.00921726, .15612207, .224591},
         {-.02080645, .19015948, .258144},
         {-.02199321, .28125150, .386858}}}},
      {1.5,
       {{{-.0336759, .11411178, .123994},
         {-.09186117, .14706189, .115998},
         {-.10513021, .60161463, .773912}}}},
      {2.0, {{{0, .11608103, .180463}, {0, .15847580, .220878}, {0, .09065943, .128411}}}},
  };
  for (const Chain &chain : chains) {
    Model model(
        {single_mass("q1", 1, 0, 0), single_mass("q2", 1, 0, 0), single_mass("q3", 1, 0, 0)});
    for (const Spring &spring :
         {Spring{-1, 0, 1, .02, 0}, Spring{0, 1, 1, .02, 0}, Spring{1, 2, 1, .02, 1},
          Spring{-1, 2, 1, .02, 0}, Spring{-1, 1, 0, 0, 1}})
      add_spring(model, spring);
    model.add_force("force",
                    std::make_shared<Harmonic>(Given::displacement, 1, chain.frequency, pi / 2),
                    {.body = 1, .point = 0}, Vector3::UnitX());
    const auto joint = constant_with(1, std::make_shared<SpringSlider>(20, 1, 0));
    const ContactSet contacts(
        {sliding_along_x(model, "q1.head", "", joint),
         sliding_along_x(model, "q1.head", "q2.head", joint),
         contact_along_x(model, "q3.head", "", 0.25, std::make_shared<LinearPenalty>(1))});
    Settings settings = settings_of("exact");
    Trajectory trajectory(model, contacts, settings);
    trajectory.start(0, Vector::Zero(3), Vector::Zero(3));
    const double period = 2 * pi / chain.frequency;
    const double settled = period * std::ceil(1500 / period);
    trajectory.advance(settled);
    std::array<Statistics, 3> found;
    constexpr int count = 1024;
    for (int i = 0; i < count; ++i) {
      trajectory.advance(settled + (i + 1) * period / count);
      for (std::size_t j = 0; j < 3; ++j) {
        const double q = trajectory.state()[static_cast<Index>(j)];
        found[j].mean += q / count;
        found[j].deviation += q * q / count;
        found[j].largest = i == 0 ? q : std::max(found[j].largest, q);
      }
    }
    for (std::size_t j = 0; j < 3; ++j) {
      Statistics &of = found[j];
      of.deviation = std::sqrt(of.deviation - of.mean * of.mean);
      const Statistics &known = chain.known[j];
      EXPECT_NEAR(of.mean, known.mean, 1e-8) << chain.frequency << ", q" << j + 1;
      EXPECT_NEAR(of.deviation, known.deviation, 1e-8) << chain.frequency << ", q" << j + 1;
      EXPECT_NEAR(of.largest, known.largest, 3e-6) << chain.frequency << ", q" << j + 1;
    }
  }
}

} // namespace friction_published_tests
} // namespace vibroimpact::motion
