// When contacts change: an interval of time owns the changes at its end and not those at its
// start, and changes at the same instant all happen, once.
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/linear_penalty.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace events_tests {

using namespace contact;
using model::Model;
using testing::contact_along_x;
using testing::single_mass;

struct Change {
  double time = 0;
  std::size_t contact = 0;
  int to = 0;
};

class Changes : public Observer {
public:
  void event(const ContactEvent &event) override {
    list.push_back({event.time, event.contact, event.to});
  }
  std::vector<Change> list;
};

// A free mass meets the stop at t = 1 and leaves it at 1 + pi / 20.
struct FreeMass {
  Model model{{single_mass("block", 1, 0, 0)}};
  ContactSet contacts{
      {contact_along_x(model, "block.head", "", 1, std::make_shared<LinearPenalty>(400))}};

  std::vector<Change> changes(double start, double speed, const std::vector<double> &ends) const {
    Trajectory trajectory(model, contacts, {});
    Changes changes;
    trajectory.start(0, Vector::Constant(1, start), Vector::Constant(1, speed));
    for (const double end : ends)
      trajectory.advance(end, changes);
    return changes.list;
  }
};

TEST(EventsTest, AnIntervalOwnsTheChangeAtItsEnd) {
  const FreeMass mass;
  for (const std::vector<double> &ends : std::vector<std::vector<double>>{
           {1.1}, {1, 1.1}, {1 - 1e-13, 1.1}, {1 + 1e-13, 1.1}, {0.5, 1, 1 + 1e-9, 1.1}}) {
    const std::vector<Change> changes = mass.changes(0, 1, ends);
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_NEAR(changes[0].time, 1, 1e-12);
    EXPECT_EQ(changes[0].to, 1);
  }
  EXPECT_EQ(mass.changes(0, 1, {1 - 1e-9}).size(), 0u);
  EXPECT_LE(mass.changes(0, 1, {1}).size(), 1u);
}

TEST(EventsTest, EveryImpactBeginsAndEndsOnce) {
  const FreeMass mass;
  const double end = 1 + std::numbers::pi / 20;
  for (const double cut : {end, end - 1e-13, end + 1e-13, 1.05}) {
    const std::vector<Change> changes = mass.changes(0, 1, {1, cut, 3});
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_NEAR(changes[1].time, end, 2e-12);
    EXPECT_EQ(changes[1].to, 0);
  }
}

TEST(EventsTest, StartAtTheStop) {
  const FreeMass mass;
  EXPECT_EQ(mass.changes(1, -1, {1}).size(), 0u); // leaves
  EXPECT_EQ(mass.changes(1, 0, {1}).size(), 0u);  // stays
  const std::vector<Change> pushed = mass.changes(1, 1, {0.1});
  ASSERT_EQ(pushed.size(), 1u);
  EXPECT_EQ(pushed[0].time, 0);
}

// A mass thrown from the stop against a spring comes back, as far as rounding can tell.
TEST(EventsTest, ComesBackHoweverSlow) {
  const Model model({single_mass("block", 1, 400, 0)});
  // The spring pulls towards the stop, which stands 0.1 m this side of its rest.
  ContactPair stop =
      contact_along_x(model, "block.head", "", -0.1, std::make_shared<LinearPenalty>(1e4));
  stop.accept_initial_penetration = true;
  const ContactSet contacts({stop});
  for (const double speed : {1e-1, 1e-3, 1e-5, 3e-6}) {
    Trajectory trajectory(model, contacts, {});
    Changes changes;
    trajectory.start(0, Vector::Constant(1, -0.1), Vector::Constant(1, -speed));
    const double back = 2 * std::atan(speed / 20 / 0.1) / 20; // 20 = sqrt(400)
    trajectory.advance(1.5 * back, changes);
    ASSERT_EQ(changes.list.size(), 1u) << speed;
    EXPECT_NEAR(changes.list[0].time, back, 2e-12 + 1e-15 / speed) << speed;
  }
}

TEST(EventsTest, ChangesAtTheSameInstant) {
  const Model model({single_mass("a", 1, 100, 0), single_mass("b", 1, 100, 0)});
  const auto law = std::make_shared<BilinearStop>(900, 5);
  ContactPair first = contact_along_x(model, "a.head", "", 0.5, law);
  ContactPair second = contact_along_x(model, "b.head", "", 0.5, law);
  ContactPair third = first; // two stops side by side
  const ContactSet contacts({first, second, third});
  Trajectory trajectory(model, contacts, {});
  Changes changes;
  trajectory.start(0, Vector::Zero(2), Vector::Constant(2, 10.0));
  trajectory.advance(0.1, changes);
  const double meets = std::asin(0.5) / 10;
  std::vector<int> begun(3, 0);
  for (const Change &change : changes.list)
    if (change.to == 1) {
      ++begun[change.contact];
      EXPECT_NEAR(change.time, meets, 2e-12);
    }
  EXPECT_EQ(begun, (std::vector<int>{1, 1, 1}));
  EXPECT_EQ(trajectory.equations().modes(), (std::vector<int>{1, 1, 1}));
  EXPECT_EQ(trajectory.accuracy().events, 3);
}

// Two masses that fall together for hundreds of metres and close a gap of a micrometre at a crawl:
// the gap is the difference of large coordinates, and its rounding is worth far more time than the
// tolerance of events.
TEST(EventsTest, RoundingOfAGapBetweenFallingMasses) {
  Model model({testing::single_mass("a", 1, 0, 0), testing::single_mass("b", 2, 0, 0)});
  testing::add_weight(model, 9.81, {0, 1});
  const ContactSet contacts(
      {testing::contact_along_x(model, "a.head", "b.head", 1e-6, testing::newton(0.5))});
  for (int i = 0; i < 40; ++i) {
    const double speed = 1e-7 * (1 + 0.037 * i);
    Settings settings;
    settings.method = i % 2 ? "rk" : "arkimex";
    Trajectory trajectory(model, contacts, settings);
    testing::Events events;
    Vector velocity = Vector::Zero(2);
    velocity[0] = speed;
    trajectory.start(0, Vector::Zero(2), velocity);
    ASSERT_NO_THROW(trajectory.advance(1.05e-6 / speed, events)) << speed;
    ASSERT_EQ(events.list.size(), 1U) << speed;
    EXPECT_NEAR(events.list[0].time, 1e-6 / speed, 1e-3 * 1e-6 / speed) << speed;
  }
}

// A falling mass is bounded by no oscillation, so that both stops lie within the first ten
// thousandth of the time that is looked at at once.
TEST(EventsTest, AFallingMassMeetsTheNearerOfTwoStops) {
  const double weight = 9.81, speed = 0.0081;
  Model model({single_mass("block", 4.3, 0, 0)});
  testing::add_weight(model, weight, {0});
  for (const double nearer : {0.0175351404482591, 0.03, 0.04, 0.0408444}) {
    const auto soft = std::make_shared<LinearPenalty>(35);
    const ContactSet contacts({contact_along_x(model, "block.head", "", 0.0408444504194515, soft),
                               contact_along_x(model, "block.head", "", nearer, soft)});
    Trajectory trajectory(model, contacts, Settings());
    Changes changes;
    trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
    const double expected = 2 * nearer / (speed + std::sqrt(speed * speed + 2 * weight * nearer));
    trajectory.advance(0.0915, changes);
    ASSERT_EQ(changes.list.size(), 2U) << nearer;
    EXPECT_EQ(changes.list[0].contact, 1U) << nearer;
    EXPECT_NEAR(changes.list[0].time, expected, 1e-14) << nearer;
  }
}

} // namespace events_tests
} // namespace vibroimpact::motion
