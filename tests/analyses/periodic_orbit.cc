// Periodic orbits as an analysis: stable and unstable motions of the isolator, recorded over one
// period, against an independent shooting solver and closed forms.
#include "analyses/curves/periodic_orbit.h"

#include "analyses/curves/orbit_fields.h"
#include "analyses/results/fields.h"

#include "common/error.h"
#include "contact/laws/bilinear_stop.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace periodic_orbit_tests {

using testing::field_of;
using testing::value_of;

/// Keeps the one point.
class OnePoint : public LineContext {
public:
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return known ? &result : nullptr;
  }
  void store(PointResult stored) override { result = std::move(stored); }
  void skip() override { skipped = true; }

  PointResult result;
  bool known = false;
  bool skipped = false;
};

System isolator(double lambda, double velocity = 0, double phase = 0) {
  model::Model model({testing::single_mass("block", 1, 1, 0.02)});
  model.add_force(
      "push", std::make_shared<model::Harmonic>(model::Given::displacement, 0.52, lambda, phase),
      {}, Vector3::UnitX());
  const auto law = std::make_shared<contact::BilinearStop>(2, 0.4);
  contact::ContactPair right = testing::contact_along_x(model, "block.head", "", 1, law);
  contact::ContactPair left = right;
  right.name = "right";
  left.name = "left";
  left.gap.row *= -1;
  System system = testing::system_of(std::move(model), contact::ContactSet({right, left}));
  system.initial.velocity[0] = velocity;
  return system;
}

OrbitStart from_state(std::vector<double> state) { return {.state = std::move(state)}; }

OrbitStart settled(long cycles) {
  return {.settling = {.minimum = 0, .maximum = cycles, .tolerance = 0, .longest_multiple = 4}};
}

PointResult run(const OrbitStart &start, System system) {
  OnePoint point;
  PeriodicOrbit({.start = start, .excitation = {}}).run_line(0, system, point);
  return point.result;
}

const std::string peak = "point/block.head/displacement_x/largest";

TEST(PeriodicOrbitTest, UnstableMotionBetweenTwoStableOnes) {
  const PointResult result = run(from_state({-0.41, -1.68}), isolator(1.3));
  ASSERT_EQ(result.status, Status::finished) << result.reason;
  EXPECT_EQ(value_of(result, "stable"), 0);
  EXPECT_EQ(value_of(result, "symmetric"), 1);
  EXPECT_EQ(value_of(result, "period_multiple"), 1);
  EXPECT_EQ(value_of(result, "events_without_derivative"), 0);
  EXPECT_LT(value_of(result, "orbit_residual"), 1e-12);
  const std::vector<double> &real = field_of(result, "multiplier_real").values;
  ASSERT_EQ(real.size(), 2u);
  EXPECT_NEAR(real[0], 1.72416, 5e-6);
  EXPECT_NEAR(real[1], 0.21243, 5e-6);
  EXPECT_NEAR(value_of(result, peak), 1.39053298, 5e-9);
  EXPECT_EQ(value_of(result, "contact/right/impacts"), 1);
  EXPECT_EQ(value_of(result, "contact/left/impacts"), 1);
  EXPECT_LT(value_of(result, "energy_residual"), 1e-10);
}

TEST(PeriodicOrbitTest, GoesOnFromAMotionThatHasHardlySettled) {
  const PointResult small = run(settled(30), isolator(1.3, -0.98));
  EXPECT_NEAR(value_of(small, peak), 0.75308873, 5e-9);
  EXPECT_EQ(value_of(small, "stable"), 1);
  EXPECT_EQ(value_of(small, "settling_cycles"), 30);
  const PointResult large = run(settled(30), isolator(1.3));
  EXPECT_NEAR(value_of(large, peak), 2.03017588, 5e-9);
  EXPECT_EQ(value_of(large, "stable"), 1);
}

// A quarter of a period earlier or later a contact is closed at phase 0: the same impacts, whole.
TEST(PeriodicOrbitTest, ImpactsAreNotCutByThePhase) {
  const PointResult whole = run(settled(200), isolator(1.3));
  for (const double phase : {0.3, 0.9, 1.5, 2.1, 2.7, 3.3})
    for (const char *of : {"impacts", "unfinished", "impulse/mean", "peak_force/maximum"}) {
      const std::string name = std::string("contact/right/") + of;
      const PointResult turned = run(settled(200), isolator(1.3, 0, phase));
      EXPECT_NEAR(value_of(turned, name), value_of(whole, name), 1e-9) << name << " " << phase;
    }
}

// With no settling the initial conditions are the start; the state that is stored leads back to the
// same motion.
TEST(PeriodicOrbitTest, StoredStateLeadsBack) {
  const PointResult first = run(settled(0), isolator(1.3));
  const PointResult again = run(from_state(field_of(first, "state").values), isolator(1.3));
  EXPECT_EQ(value_of(first, "settling_cycles"), 0);
  EXPECT_LE(value_of(again, "newton_iterations"), 1);
  EXPECT_NEAR(value_of(again, peak), value_of(first, peak), 1e-12);
}

// An array along a dimension of its own name would be the coordinate of that dimension.
TEST(PeriodicOrbitTest, StateIsNoCoordinate) {
  const Field state = field_of(run(settled(0), isolator(1.3)), "state");
  EXPECT_EQ(state.dimensions(), std::vector<std::string>{"state_index"});
  EXPECT_EQ(state.shape, std::vector<std::size_t>{2});
}

TEST(PeriodicOrbitTest, SaysWhereTheMotionHadSettledToSomethingElse) {
  const auto found = [](std::optional<long> multiple, double stable) {
    PointResult result;
    FieldWriter(result).number("stable", stable, "1", "");
    add_settled_multiple(result, multiple);
    return result;
  };
  EXPECT_TRUE(settled_elsewhere(found(0, 0)));
  EXPECT_NE(found(0, 0).reason.find("Longest period"), std::string::npos);
  for (const PointResult &fine : {found(0, 1), found(2, 0), found(std::nullopt, 0)}) {
    EXPECT_FALSE(settled_elsewhere(fine));
    EXPECT_EQ(fine.reason, "");
  }
  EXPECT_EQ(value_of(run(settled(30), isolator(1.3)), "settled_multiple"), 0); // tolerance 0
  EXPECT_TRUE(std::isnan(value_of(run(settled(0), isolator(1.3)), "settled_multiple")));
}

TEST(PeriodicOrbitTest, FailureIsRecordedWithItsReason) {
  model::Model model({testing::single_mass("block", 1, 1, 0)});
  model.add_force("push", std::make_shared<model::Harmonic>(model::Given::displacement, 1, 1, 0),
                  {}, Vector3::UnitX());
  const PointResult result = run(settled(3), testing::system_of(std::move(model)));
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_NE(result.reason.find("no periodic motion"), std::string::npos) << result.reason;
}

TEST(PeriodicOrbitTest, FinishedPointIsSkipped) {
  OnePoint point;
  point.known = true;
  System system = isolator(1.3);
  PeriodicOrbit({.start = settled(0), .excitation = {}}).run_line(0, system, point);
  EXPECT_TRUE(point.skipped);
}

} // namespace periodic_orbit_tests
} // namespace vibroimpact::analyses
