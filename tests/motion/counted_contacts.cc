// How many nonlinear contacts were solved as a whole, and why the others were not.
#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt.h"
#include "motion/path/trajectory.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace counted_contacts_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

// Contacts that begin with a force that is not linear.
class Onsets : public Observer {
public:
  explicit Onsets(const ContactSet &contacts) : contacts_(contacts) {}
  void event(const ContactEvent &event) override {
    const ContactLaw &law = *contacts_.pairs()[event.contact].law;
    count += event.onset && !law.modes()[static_cast<std::size_t>(event.to)].affine ? 1 : 0;
  }
  long count = 0;

private:
  const ContactSet &contacts_;
};

// A mass of 1 kg on a spring before a stop of 1 MN/m^(3/2) at 0.25 m, shaken at its base. It may
// carry another mass.
struct Shaken {
  explicit Shaken(double rider_mass = 0, double rider_stiffness = 0, double cubic = 0)
      : model(bodies(rider_mass)) {
    std::vector<std::size_t> all = {0};
    if (rider_stiffness > 0)
      all.push_back(1);
    model.add_base_motion("table", std::make_shared<Harmonic>(Given::displacement, 0.3, 1.3, phase),
                          all, Vector3::UnitX());
    if (rider_stiffness > 0) {
      Projection elongation = seen(0);
      elongation.row -= seen(1).row;
      connect("rider.head", elongation, rider_stiffness, 0);
    }
    if (cubic > 0)
      connect("", seen(0), 0, cubic);
    stop(hertz(), 0.25);
  }

  static std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies(double rider_mass) {
    std::vector<std::shared_ptr<const reduction::ReducedBody>> list = {
        single_mass("mass", 1, 1, 0.06)};
    if (rider_mass > 0)
      list.push_back(single_mass("rider", rider_mass, 0, 0));
    return list;
  }
  static std::shared_ptr<const ContactLaw> hertz() {
    return std::make_shared<Hertz>(HertzConstants{.stiffness = 1e6});
  }
  Projection seen(std::size_t body) const {
    return model.displacement({.body = body, .point = 0}, Vector3::UnitX(), false);
  }
  void connect(const std::string &to, const Projection &elongation, double stiffness,
               double cubic) {
    model.add_connection({.name = "spring",
                          .side_a = "mass.head",
                          .side_b = to,
                          .elongation = elongation,
                          .stiffness = stiffness,
                          .cubic_stiffness = cubic});
  }
  void stop(const std::shared_ptr<const ContactLaw> &law, double clearance) {
    pairs.push_back(contact_along_x(model, "mass.head", "", clearance, law));
    contacts = ContactSet(pairs);
  }

  // The numbers must agree with what an observer sees.
  Accuracy run(const Settings &settings = {}, double stretch = 40, double end = 40,
               double from = 0) const {
    Trajectory trajectory(model, contacts, settings);
    Onsets onsets(contacts);
    Vector start = Vector::Zero(model.size());
    start[0] = from;
    trajectory.start(0, start, Vector::Constant(model.size(), 0.5));
    for (int i = 1; trajectory.time() < end; ++i)
      trajectory.advance(std::min(end, i * stretch), onsets);
    const Accuracy accuracy = trajectory.accuracy();
    EXPECT_EQ(accuracy.contact_episodes + accuracy.stepped_contacts(), onsets.count);
    EXPECT_GT(onsets.count, 0);
    return accuracy;
  }

  static constexpr double phase = 0.3;
  Model model;
  std::vector<ContactPair> pairs;
  ContactSet contacts;
};

long number(const Accuracy &accuracy, StepReason reason) {
  return accuracy.step_reasons[static_cast<std::size_t>(reason)];
}

// All of those that are left are so for this reason.
void expect_only(const Accuracy &accuracy, StepReason reason) {
  EXPECT_GT(number(accuracy, reason), 0);
  EXPECT_EQ(number(accuracy, reason), accuracy.stepped_contacts());
}

TEST(CountedContacts, AreWholeWhereNothingForbidsIt) {
  const Accuracy accuracy = Shaken().run();
  EXPECT_GT(accuracy.contact_episodes, 5);
  EXPECT_EQ(accuracy.stepped_contacts(), 0);
}

TEST(CountedContacts, AreInStepsByOtherMethods) {
  const Accuracy accuracy = Shaken().run({.method = "rk"});
  EXPECT_EQ(accuracy.contact_episodes, 0);
  expect_only(accuracy, StepReason::method);
}

TEST(CountedContacts, AreInStepsBesideCubicSprings) {
  const Accuracy accuracy = Shaken(0, 0, 0.1).run();
  EXPECT_EQ(accuracy.contact_episodes, 0);
  expect_only(accuracy, StepReason::system);
}

// The second stop is met while the first one pushes.
TEST(CountedContacts, AreInStepsBesideOthers) {
  Shaken shaken;
  shaken.stop(Shaken::hertz(), 0.25 + 1e-5);
  const Accuracy accuracy = shaken.run();
  EXPECT_GT(number(accuracy, StepReason::neighbour), 0);
  EXPECT_GT(number(accuracy, StepReason::system), 0);
  EXPECT_EQ(number(accuracy, StepReason::neighbour) + number(accuracy, StepReason::system),
            accuracy.stepped_contacts());
}

// A linear stop at the same place, whose force begins at the same instant.
TEST(CountedContacts, AreInStepsWhereContactsChangeTogether) {
  Shaken shaken;
  shaken.stop(std::make_shared<KelvinVoigt>(2000, 5), 0.25);
  const Accuracy accuracy = shaken.run();
  expect_only(accuracy, StepReason::neighbour);
}

// It begins at the touch.
TEST(CountedContacts, AreInStepsWhereTheyBeginTheMotion) {
  const double touch = 0.25 - 0.3 * std::sin(Shaken::phase); // the base has moved
  const Accuracy accuracy = Shaken().run({}, 40, 40, touch);
  EXPECT_EQ(number(accuracy, StepReason::undecided), 1);
  EXPECT_GT(accuracy.contact_episodes, 5);
}

TEST(CountedContacts, AreInStepsAcrossInterruptions) {
  expect_only(Shaken().run({}, 0.01), StepReason::interrupted);
  const Accuracy accuracy = Shaken().run({.maximum_step = 1e-3});
  EXPECT_EQ(accuracy.contact_episodes, 0);
  expect_only(accuracy, StepReason::interrupted);
}

TEST(CountedContacts, AreInStepsWhereAModeIsFast) {
  const Accuracy accuracy = Shaken(0.4, 2e7).run();
  EXPECT_EQ(accuracy.contact_episodes, 0);
  EXPECT_GT(number(accuracy, StepReason::fast), 0);
  EXPECT_EQ(number(accuracy, StepReason::fast) + number(accuracy, StepReason::pause),
            accuracy.stepped_contacts());
}

// The mass bounces several times while its heavy rider turns round.
TEST(CountedContacts, AreInStepsWhereTheForceHasHumps) {
  const Accuracy accuracy = Shaken(30, 1e5).run();
  EXPECT_GT(number(accuracy, StepReason::shape), 0);
  EXPECT_EQ(number(accuracy, StepReason::shape) + number(accuracy, StepReason::pause),
            accuracy.stepped_contacts());
}

// While a rigid stop holds another mass.
TEST(CountedContacts, AreInStepsBesideAGapThatIsHeld) {
  Shaken shaken(0.4, 0);
  testing::add_weight(shaken.model, 9.81, {1});
  shaken.pairs.clear();
  shaken.stop(Shaken::hertz(), 0.25);
  shaken.pairs.push_back(contact_along_x(shaken.model, "rider.head", "", 0, testing::newton(0)));
  shaken.contacts = ContactSet(shaken.pairs);
  const Accuracy accuracy = shaken.run();
  EXPECT_GT(number(accuracy, StepReason::law), 5);
}

// Instants are not asked for more exactly than that.
TEST(CountedContacts, AreInStepsWhereTheyAreShorterThanInstantsAreExact) {
  expect_only(Shaken().run({.event_tolerance = 1e-3}), StepReason::shallow);
}

} // namespace counted_contacts_tests
} // namespace vibroimpact::motion
