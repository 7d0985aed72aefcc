// Motions that are hard to advance: contacts that change at one instant, or without speed, or while
// nothing but the base moves. Each by every way to advance it.
#include "analyses/run/system.h"
#include "common/error.h"
#include "motion/path/trajectory.h"
#include "reduction/reduce_body.h"
#include "support/simulation_files.h"
#include "text_of.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace hard_motions_tests {

using namespace motion;
using analyses::System;
using reduction::ReducedBody;

System system_of(const std::string &model, const std::vector<parameters::Override> &overrides) {
  const std::string path =
      std::string(VIBROIMPACT_SOURCE_DIR) + "/tests/simulation/models/" + model + ".prm";
  const auto set = parameters::ParameterSet::parse(declare_parameters(), testing::text_of(path),
                                                   path, false, overrides);
  const parameters::Values root = set->root();
  std::vector<std::shared_ptr<const ReducedBody>> bodies;
  for (const std::string &name : root.instances("Body"))
    bodies.push_back(std::make_shared<ReducedBody>(
        reduction::reduce_body(root.instance("Body", name), name, ".", MPI_COMM_SELF)));
  return analyses::build_system(root, root.instance("Analysis", root.instances("Analysis").front()),
                                bodies);
}

/// Gaps at equal distances in time [m], and the force of each contact as the step sees it [N].
class Samples : public Observer {
public:
  explicit Samples(double interval) : interval_(interval) {}
  void step(const StepView &view) override {
    for (; next_ * interval_ < view.end(); ++next_) {
      const double tau = (next_ * interval_ - view.start()) / view.length();
      std::vector<double> gaps, forces;
      for (std::size_t c = 0; c < view.equations().contacts().size(); ++c) {
        gaps.push_back(view.gap(c)(tau));
        forces.push_back(view.force(c, tau));
      }
      gap.push_back(gaps);
      force.push_back(forces);
    }
  }
  std::vector<std::vector<double>> gap, force;

private:
  double interval_;
  double next_ = 0;
};

struct Moved {
  Samples samples;
  Accuracy accuracy;
};

constexpr int n_samples = 400;

Moved motion(const std::string &model, const std::string &method, double duration,
             const std::string &step = "") {
  std::vector<parameters::Override> overrides = {
      {.path = "Integration/Method", .value = method, .origin = "test"}};
  if (!step.empty())
    overrides.push_back({.path = "Integration/Maximum step", .value = step, .origin = "test"});
  const System system = system_of(model, overrides);
  Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  Moved moved{.samples = Samples(duration / n_samples), .accuracy = {}};
  trajectory.advance(duration, moved.samples);
  moved.accuracy = trajectory.accuracy();
  return moved;
}

/// Largest difference over the largest value, the largest 2 % of the differences left out: samples
/// at a jump.
double difference(const std::vector<std::vector<double>> &one,
                  const std::vector<std::vector<double>> &other) {
  double size = 0;
  std::vector<double> apart;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    for (std::size_t c = 0; c < one[i].size(); ++c) {
      size = std::max(size, std::abs(other[i][c]));
      apart.push_back(std::abs(one[i][c] - other[i][c]));
    }
  std::sort(apart.begin(), apart.end());
  return apart[apart.size() * 98 / 100] / size;
}

struct Case {
  const char *model;
  double duration; ///< [s]
};

class HardMotionsTest : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Models, HardMotionsTest,
                         ::testing::Values(Case{"touching_on_both_sides", 1.01},
                                           Case{"contacts_that_part_together", 21.8},
                                           Case{"two_laws_at_one_place", 3.48},
                                           Case{"impact_drives_into_another_contact", 2.94},
                                           Case{"touching_without_acceleration", 1.77},
                                           Case{"pressed_on_with_another_mass", 5.9},
                                           Case{"pressed_on_between_two_contacts", 2.0},
                                           Case{"held_while_another_contact_parts", 1.6},
                                           Case{"held_beside_a_compressed_contact", 1.2}),
                         [](const auto &info) { return std::string(info.param.model); });

// Two methods of different order and with different searches for contact changes.
TEST_P(HardMotionsTest, SameByTwoMethods) {
  const auto [model, duration] = GetParam();
  const Moved one = motion(model, "exact", duration);
  const Moved other = motion(model, "rk", duration, std::to_string(duration / 4000) + " s");
  EXPECT_TRUE(one.accuracy.balanced()) << one.accuracy.energy_residual;
  EXPECT_TRUE(other.accuracy.balanced()) << other.accuracy.energy_residual;
  ASSERT_EQ(one.samples.gap.size(), other.samples.gap.size());
  EXPECT_LT(difference(one.samples.gap, other.samples.gap), 1e-6);
  EXPECT_LT(difference(one.samples.force, other.samples.force), 1e-5);
}

// While only the base moves, a maximum step bounds the errors of forces and work, as the warning
// says that an open energy balance gives. Without one the balance tells.
TEST(HardMotionsTest, HeldAgainstAMovingStop) {
  constexpr const char *model = "held_against_a_moving_stop";
  constexpr double duration = 0.99;
  const Moved free = motion(model, "exact", duration);
  const Moved one = motion(model, "exact", duration, "0.25 ms");
  const Moved other = motion(model, "rk", duration, "0.25 ms");
  EXPECT_TRUE(one.accuracy.balanced()) << one.accuracy.energy_residual;
  EXPECT_TRUE(other.accuracy.balanced()) << other.accuracy.energy_residual;
  EXPECT_LT(difference(one.samples.gap, other.samples.gap), 1e-6);
  EXPECT_LT(difference(one.samples.force, other.samples.force), 1e-5);
  EXPECT_TRUE(difference(free.samples.gap, one.samples.gap) < 1e-6 || !free.accuracy.balanced());
}

// Stiff ones, for which steps of Runge-Kutta take long.
TEST(HardMotionsTest, BodiesPressedOnComeToRest) {
  for (const Case &pressed :
       {Case{"pressed_on_slowly", 1.2}, Case{"pressed_on_beside_three_contacts", 0.7}}) {
    const Moved moved = motion(pressed.model, "exact", pressed.duration);
    EXPECT_TRUE(moved.accuracy.balanced()) << pressed.model;
    EXPECT_LT(moved.accuracy.events, 100) << pressed.model;
  }
}

// Unobserved, as while a motion settles: exact propagation without steps as far as it is clear.
TEST(HardMotionsTest, ContactsThatCloseTogetherUnobserved) {
  const System system = system_of("symmetric_plate_on_stops", {});
  Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  trajectory.advance(0.5);
  EXPECT_EQ(trajectory.time(), 0.5);
  EXPECT_LT(trajectory.accuracy().steps, 1000000);
}

} // namespace hard_motions_tests
} // namespace vibroimpact
