// Springs with a dashpot between them: closed forms, and a published history with a power.
#include "contact/laws/zener_spring.h"

#include "common/decompositions.h"
#include "model/piecewise_function.h"
#include "motion/path/trajectory.h"
#include "support/law_checks.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::contact {
namespace zener_spring_tests {

using motion::Trajectory;
using testing::contact_along_x;
using testing::single_mass;

const ZenerConstants published = {
    .series = 120, .parallel = 10, .branch = 60, .damping = 1.7, .exponent = 0.5};

TEST(ZenerSpringTest, DerivativesPowerAndAffineForm) {
  ZenerConstants linear = published;
  linear.exponent = 1;
  ZenerConstants maxwell{.branch = 60, .damping = 2};
  for (const ZenerConstants &constants : {published, linear, maxwell})
    for (const double z : {-0.2, 0.7})
      testing::check_law(ZenerSpring(constants),
                         {.mode = 0, .gap = 0.3, .gap_rate = -0.4, .internal = {z}});
  EXPECT_TRUE(ZenerSpring(published).always_in_contact());
}

// x'' + x + T = -sin(10 pi t), digits of case SDND107 of Code_Aster.
TEST(ZenerSpringTest, PublishedHistoryWithAPower) {
  model::Model model({single_mass("block", 1, 1, 0)});
  model.add_force(
      "push",
      std::make_shared<model::Harmonic>(model::Given::displacement, -1, 10 * std::numbers::pi, 0),
      {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0, std::make_shared<ZenerSpring>(published))});
  Trajectory trajectory(model, contacts, {.relative_tolerance = 1e-13});
  motion::Observer nobody;
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  struct Value {
    double time, place, digit;
  };
  for (const Value &value : {Value{0.01, -5.20902912e-6, 1e-14},
                             {0.1, -3.090767117e-3, 1e-12},
                             {0.2, -4.904988850e-3, 1e-12},
                             {0.3, -4.920555236e-3, 1e-12},
                             {0.4, -3.336651365e-3, 1e-12},
                             {0.5, -9.879441228e-4, 1e-13},
                             {0.66, 2.856303317e-3, 1e-12},
                             {0.75, 1.021827262e-3, 1e-12}}) {
    trajectory.advance(value.time, nobody);
    EXPECT_NEAR(trajectory.state()[0], value.place, value.digit) << value.time;
  }
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-11);
}

// With a = 1 the state [x, x', z] has a constant matrix; the exact method carries it as such.
TEST(ZenerSpringTest, LinearDashpotIsPropagatedExactly) {
  const model::Model model({single_mass("block", 2, 30, 0)});
  for (const bool rigid : {false, true}) {
    ZenerConstants constants = published;
    constants.exponent = 1;
    if (rigid)
      constants.series.reset();
    const ContactSet contacts(
        {contact_along_x(model, "block.head", "", 0, std::make_shared<ZenerSpring>(constants))});
    Trajectory trajectory(model, contacts, {});
    motion::Observer nobody;
    trajectory.start(0, Vector::Constant(1, 0.1), Vector::Constant(1, -0.3));
    trajectory.advance(0.9, nobody);
    // e = -x; e2 follows from k1 (e - e2) = k2 e2 + k3 (e2 - z).
    const double sum = 120 + 10 + 60;
    const double inner = rigid ? 1 : 120 / sum, by_z = rigid ? 0 : 60 / sum;
    Matrix generator(3, 3);
    generator << 0, 1, 0, -(30 + 70 * inner) / 2, 0, (70 * by_z - 60) / 2, -60 * inner / 1.7, 0,
        60 * (by_z - 1) / 1.7;
    const Vector expected = exponential(0.9 * generator) * Vector3(0.1, -0.3, 0);
    EXPECT_LT((trajectory.state().head(3) - expected).norm(), 1e-14) << rigid;
    EXPECT_LT(trajectory.accuracy().energy_residual, 1e-13) << rigid;
  }
}

// A body without springs on Maxwell's model under a load ends at the speed F / c.
TEST(ZenerSpringTest, MaxwellsModelCreeps) {
  model::Model model({single_mass("block", 1, 0, 0)});
  model.add_force("load", model::make_constant(model::Given::displacement, 5),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0,
                       std::make_shared<ZenerSpring>(ZenerConstants{.branch = 60, .damping = 8}))});
  Trajectory trajectory(model, contacts, {});
  motion::Observer nobody;
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  trajectory.advance(40, nobody);
  EXPECT_NEAR(trajectory.state()[1], 5.0 / 8, 1e-12);
}

} // namespace zener_spring_tests
} // namespace vibroimpact::contact
