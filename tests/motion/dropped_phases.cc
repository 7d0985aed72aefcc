// Linear phases that are dropped where what is prepared has a bound: motions stay the same to the
// last bit, and the bound is kept.
#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "model/recorded_history.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "motion/phase/exact_phases.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace dropped_phases_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

// Masses on a shaken table between stops of several kinds. A recorded push breaks the excitation.
struct Row {
  explicit Row(int count) : model(bodies(count)) {
    std::vector<std::size_t> all;
    for (int i = 0; i < count; ++i)
      all.push_back(static_cast<std::size_t>(i));
    model.add_base_motion("table", std::make_shared<Harmonic>(Given::displacement, 0.3, 1.1, 0.3),
                          all, Vector3::UnitX());
    const Samples push{.time = {0, 2, 5, 6, 9, 40}, .value = {0, 0.2, -0.3, 0.1, 0.1, 0}};
    model.add_force(
        "push",
        make_recorded(Given::displacement, push, Interpolation::linear, OutsideRecord::zero),
        {.body = 0, .point = 0}, Vector3::UnitX());
    const std::vector<std::shared_ptr<const ContactLaw>> laws = {
        std::make_shared<LinearPenalty>(60),
        std::make_shared<Hertz>(HertzConstants{.stiffness = 1e6}),
        std::make_shared<KelvinVoigtBumper>(40, 3)};
    std::vector<ContactPair> pairs;
    for (int i = 0; i < count; ++i)
      pairs.push_back(contact_along_x(model, "m" + std::to_string(i) + ".head", "", 0.2,
                                      laws[static_cast<std::size_t>(i) % laws.size()]));
    contacts = ContactSet(pairs);
  }
  static std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies(int count) {
    std::vector<std::shared_ptr<const reduction::ReducedBody>> list;
    for (int i = 0; i < count; ++i)
      list.push_back(single_mass("m" + std::to_string(i), 1, 1 + 0.3 * i, 0.05));
    return list;
  }
  Model model;
  ContactSet contacts;
};

struct Moved {
  Vector state;
  Accuracy accuracy;
  std::vector<Impact> impacts;
};

// Two motions one after the other, the first with its impacts.
Moved moved(const Row &row, std::size_t prepared_bytes, bool in_steps) {
  class Steps : public Observer {
  } steps;
  Settings settings;
  settings.prepared_bytes = prepared_bytes;
  Trajectory trajectory(row.model, row.contacts, settings);
  const Vector rest = Vector::Zero(row.model.size());
  Moved result;
  for (int motion = 0; motion < 2; ++motion) {
    trajectory.start(0, rest, rest);
    ImpactLog log(row.contacts, 0);
    trajectory.advance(12, log);
    trajectory.advance(24, in_steps ? Observers({&log, &steps}) : Observers(log));
    result.impacts.clear();
    for (std::size_t c = 0; c < row.contacts.size(); ++c)
      result.impacts.insert(result.impacts.end(), log.impacts(c).begin(), log.impacts(c).end());
  }
  result.state = trajectory.state();
  result.accuracy = trajectory.accuracy();
  return result;
}

TEST(DroppedPhasesTest, LeaveMotionsAsTheyAre) {
  const Row row(6);
  for (const bool in_steps : {false, true}) {
    const Moved kept = moved(row, Settings().prepared_bytes, in_steps);
    ASSERT_GT(kept.accuracy.events, 60);
    ASSERT_GT(kept.accuracy.contact_episodes, 5);
    for (const std::size_t bound : {0, 100'000}) {
      const Moved dropped = moved(row, bound, in_steps);
      EXPECT_EQ(dropped.accuracy.steps, kept.accuracy.steps);
      EXPECT_EQ(dropped.accuracy.events, kept.accuracy.events);
      EXPECT_EQ(dropped.accuracy.contact_episodes, kept.accuracy.contact_episodes);
      EXPECT_EQ(dropped.state, kept.state);
      ASSERT_EQ(dropped.impacts.size(), kept.impacts.size());
      for (std::size_t i = 0; i < kept.impacts.size(); ++i)
        EXPECT_EQ(dropped.impacts[i].peak_force, kept.impacts[i].peak_force);
    }
  }
}

// All combinations of seven contacts. The phase that the motion is in is never dropped.
TEST(DroppedPhasesTest, KeepTheBound) {
  const Row row(7);
  Equations equations(row.model, row.contacts);
  Settings settings;
  settings.prepared_bytes = 300'000;
  ExactPhases phases(equations, settings);
  ASSERT_TRUE(phases.take_sources(0));
  std::size_t made = 0;
  for (unsigned combination = 0; combination < 128; ++combination) {
    for (std::size_t c = 0; c < 7; ++c)
      equations.set_mode(c, c % 3 != 1 && (combination >> c & 1) != 0 ? 1 : 0);
    LinearPhase *const phase = phases.present();
    ASSERT_NE(phase, nullptr);
    phases.enter(*phase);
    EXPECT_LE(phases.bytes(), settings.prepared_bytes);
    EXPECT_EQ(phases.present(), phase);
    made += phase->bytes();
  }
  EXPECT_GT(made, 5 * settings.prepared_bytes);
}

} // namespace dropped_phases_tests
} // namespace vibroimpact::motion
