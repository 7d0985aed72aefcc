// Motions through nonlinear contacts that are solved as a whole, against Runge-Kutta steps at a
// much smaller tolerance, and against what is conserved.
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/tsuji.h"
#include "motion/episode/contact_steps.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace collocated_contacts_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

// A mass of 1 kg on a spring between a nonlinear stop and one more contact, driven at its base.
struct Shaken {
  explicit Shaken(const std::shared_ptr<const ContactLaw> &law,
                  const std::shared_ptr<const ContactLaw> &other = nullptr)
      : model({single_mass("mass", 1, 1, 0.06)}) {
    model.add_base_motion("table",
                          std::make_shared<Harmonic>(Given::displacement, 0.3, frequency, 0.3), {0},
                          Vector3::UnitX());
    std::vector<ContactPair> pairs = {contact_along_x(model, "mass.head", "", 0.25, law)};
    if (other) {
      pairs.push_back(contact_along_x(model, "mass.head", "", 0.3, other));
      pairs.back().gap.row *= -1;
      for (double &coefficient : pairs.back().gap.base_coefficients)
        coefficient *= -1;
    }
    contacts = ContactSet(pairs);
  }
  static constexpr double frequency = 1.3;
  Model model;
  ContactSet contacts;
};

// Counts the contacts that were solved as a whole: their steps end at the points of ForceTools.
class ContactEpisodes : public Observer {
public:
  ContactEpisodes(const ContactLaw &law, double tolerance) : law_(law), tolerance_(tolerance) {}
  void step(const StepView &view) override {
    if (inside_)
      ends_.push_back(view.end());
  }
  void event(const ContactEvent &event) override {
    if (event.onset) {
      inside_ = true;
      ends_ = {event.time};
    } else if (inside_) {
      inside_ = false;
      const ForcePulse course = *law_.force_pulse(event.from);
      const bool whole =
          std::any_of(course.ends.begin(), course.ends.end(), [&](const ForcePulse::End &end) {
            return ends_at_points({.begin = course.begin.power,
                                   .end = end.edge.power,
                                   .nodes = 8,
                                   .begin_root = course.begin.root,
                                   .end_root = end.edge.root});
          });
      ++(whole ? count : others);
    }
  }
  int count = 0, others = 0;

private:
  bool ends_at_points(const ForceShape &shape) const {
    const LongArray &points =
        force_tools(shape).shown(ContactSteps::inner_points(tolerance_)).rule.nodes;
    bool equal = ends_.size() == static_cast<std::size_t>(points.size());
    for (std::size_t i = 0; equal && i < ends_.size(); ++i) {
      const double part = (ends_[i] - ends_[0]) / (ends_.back() - ends_[0]);
      equal = std::abs(part - static_cast<double>(points[static_cast<Index>(i)])) < 1e-6;
    }
    return equal;
  }

  const ContactLaw &law_;
  double tolerance_;
  bool inside_ = false;
  std::vector<double> ends_;
};

struct Result {
  Vector state; ///< with the work integrals
  std::vector<Impact> impacts;
  Accuracy accuracy;
  int contact_episodes = 0, other_contacts = 0;
};

// From a kick, so that the stop is met at several speeds before the motion repeats itself.
Result integrate(const Shaken &shaken, const std::string &method, double tolerance,
                 double end = 40) {
  Trajectory trajectory(shaken.model, shaken.contacts,
                        {.method = method, .relative_tolerance = tolerance});
  ImpactLog log(shaken.contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 0.5));
  ContactEpisodes contacts(*shaken.contacts.pairs()[0].law, tolerance);
  Observers observers({&log, &contacts});
  trajectory.advance(end, observers);
  return {trajectory.state(), log.impacts(0), trajectory.accuracy(), contacts.count,
          contacts.others};
}

std::vector<std::shared_ptr<const ContactLaw>> laws() {
  return {std::make_shared<Hertz>(HertzConstants{.stiffness = 1e6}),
          std::make_shared<Hertz>(HertzConstants{.stiffness = 1e7, .exponent = 2.2}),
          HuntCrossley::with_dissipation({.stiffness = 1e6}, 0.3),
          HuntCrossley::with_dimensionless_damping({.stiffness = 1e6}, 0.4, 1e-6),
          std::make_shared<KuwabaraKono>(1e6, 1e-3),
          std::make_shared<Tsuji>(1e6, 300)};
}

TEST(CollocatedContacts, AgreeWithRungeKuttaSteps) {
  for (const auto &law : laws()) {
    const Shaken shaken(law);
    const Result whole = integrate(shaken, "exact", 1e-9);
    const Result steps = integrate(shaken, "rk", 1e-13);
    EXPECT_GT(whole.contact_episodes, 5) << law->name();
    EXPECT_EQ(whole.other_contacts, 0) << law->name();
    EXPECT_EQ(steps.contact_episodes, 0) << law->name();
    ASSERT_EQ(whole.impacts.size(), steps.impacts.size()) << law->name();
    EXPECT_LT((whole.state.head(2) - steps.state.head(2)).norm(), 1e-7) << law->name();
    for (std::size_t i = 0; i < whole.impacts.size(); ++i) {
      const Impact &a = whole.impacts[i];
      const Impact &b = steps.impacts[i];
      const double speed = b.approach_speed;
      EXPECT_NEAR(a.start_time, b.start_time, 1e-7) << law->name() << ", impact " << i;
      EXPECT_NEAR(a.duration / b.duration, 1, 1e-6);
      EXPECT_NEAR(a.approach_speed, b.approach_speed, 1e-7);
      EXPECT_NEAR(a.separation_speed, b.separation_speed, 1e-7);
      EXPECT_NEAR(a.impulse, b.impulse, 1e-7);
      EXPECT_NEAR(a.peak_force / b.peak_force, 1, 1e-6);
      EXPECT_NEAR(a.maximum_penetration / b.maximum_penetration, 1, 1e-6);
      EXPECT_NEAR(a.dissipated_energy, b.dissipated_energy, 1e-7 * speed * speed);
    }
  }
}

// Loads, dampers, the moving base and the contact: what they do adds up to what is stored.
TEST(CollocatedContacts, CloseTheEnergyBalance) {
  for (const auto &law : laws()) {
    const Shaken shaken(law);
    const Result whole = integrate(shaken, "exact", 1e-9);
    EXPECT_LT(whole.accuracy.energy_residual, 1e-8) << law->name();
    EXPECT_GT(whole.accuracy.energy_threshold, 1e-10); // the steps were not exact
  }
}

// The same integrals as those that a Runge-Kutta method carries along.
TEST(CollocatedContacts, KeepTheWorkIntegrals) {
  for (const auto &law : laws()) {
    const Shaken shaken(law, std::make_shared<KelvinVoigt>(2000, 5));
    const Result whole = integrate(shaken, "exact", 1e-10);
    const Result steps = integrate(shaken, "rk", 1e-13);
    const Index absolute = 3; // which is a lower bound in linear phases
    for (Index k = 2; k < whole.state.size(); ++k) {
      if (k == absolute + (law->n_internal() > 0 ? 1 : 0))
        continue;
      EXPECT_NEAR(whole.state[k], steps.state[k], 1e-7) << law->name() << ", entry " << k;
    }
  }
}

TEST(CollocatedContacts, DoNotDependOnMotionsBefore) {
  const Shaken shaken(std::make_shared<Hertz>(HertzConstants{.stiffness = 1e6}));
  Trajectory used(shaken.model, shaken.contacts, {});
  Trajectory fresh(shaken.model, shaken.contacts, {});
  used.start(0, Vector::Zero(1), Vector::Constant(1, 3));
  used.advance(30);
  for (Trajectory *trajectory : {&used, &fresh}) {
    trajectory->start(0, Vector::Zero(1), Vector::Constant(1, 0.5));
    trajectory->advance(30);
  }
  EXPECT_GT(fresh.events(), 6);
  EXPECT_EQ(used.state()[0], fresh.state()[0]);
  EXPECT_EQ(used.state()[1], fresh.state()[1]);
}

// Two stops so close to each other that the second is met while the first still pushes, and a limit
// within a contact: others do it, with the same result.
TEST(CollocatedContacts, LeaveToOthersWhatTheyCannotDo) {
  const auto law = std::make_shared<Hertz>(HertzConstants{.stiffness = 1e4});
  Shaken shaken(law);
  std::vector<ContactPair> pairs = {shaken.contacts.pairs()[0], shaken.contacts.pairs()[0]};
  pairs[1].clearance += 1e-3;
  shaken.contacts = ContactSet(pairs);
  const Result whole = integrate(shaken, "exact", 1e-10);
  const Result steps = integrate(shaken, "rk", 1e-13);
  EXPECT_EQ(whole.accuracy.events, steps.accuracy.events);
  EXPECT_LT((whole.state.head(2) - steps.state.head(2)).norm(), 1e-6);

  const Shaken single(law);
  Trajectory parts(single.model, single.contacts, {});
  Trajectory all(single.model, single.contacts, {});
  for (Trajectory *trajectory : {&parts, &all})
    trajectory->start(0, Vector::Zero(1), Vector::Constant(1, 0.5));
  const double tolerance = Settings{}.relative_tolerance;
  ContactEpisodes of_parts(*law, tolerance);
  ContactEpisodes of_all(*law, tolerance);
  for (int i = 1; i <= 4000; ++i)
    parts.advance(0.01 * i, of_parts);
  all.advance(40, of_all);
  EXPECT_LT(of_parts.count, of_all.count);
  EXPECT_EQ(parts.events(), all.events());
  EXPECT_LT((parts.state().head(2) - all.state().head(2)).norm(), 1e-6);
}

// Extreme values over each contact of what two masses do, and of the force between one and a stop:
// as linear forms, or from the steps that are shown.
class ContactExtremes : public Observer {
public:
  ContactExtremes(const Model &model, bool in_steps) : in_steps_(in_steps) {
    for (const std::size_t body : {0, 1})
      for (const int order : {0, 1, 2})
        forms_.emplace_back(PointForm{
            model.displacement({.body = body, .point = 0}, Vector3::UnitX(), true), order});
    forms_.emplace_back(GapForm{0});
    forms_.emplace_back(ForceForm{0});
  }
  bool sees_steps(const Equations & /*equations*/) const override { return in_steps_; }
  void outputs(const Equations &equations, std::vector<Output> &list) override {
    for (std::size_t i = 0; i < forms_.size() && equations.mode(0).in_contact; ++i)
      list.push_back({&forms_[i], &ranges_[i]});
  }
  void event(const ContactEvent &event) override {
    // A force that is cut off ends before the sides part.
    if (!event.onset && inside_)
      contacts.push_back(ranges_);
    inside_ = event.onset;
    ranges_ = {};
  }

  using Ranges = std::array<ValueRange, 8>; ///< x, v, a of both masses, gap, force
  std::vector<Ranges> contacts;

private:
  bool in_steps_, inside_ = false;
  std::vector<OutputForm> forms_;
  Ranges ranges_;
};

// A mass that meets a stop and carries another one.
struct Carrier {
  explicit Carrier(const std::shared_ptr<const ContactLaw> &law)
      : model({single_mass("mass", 1, 1, 0.06), single_mass("rider", 0.4, 30, 0.2)}) {
    model.add_base_motion(
        "table", std::make_shared<Harmonic>(Given::displacement, 0.3, Shaken::frequency, 0.3),
        {0, 1}, Vector3::UnitX());
    Projection elongation = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
    elongation.row -= model.displacement({.body = 1, .point = 0}, Vector3::UnitX(), false).row;
    model.add_connection({.name = "spring",
                          .side_a = "mass.head",
                          .side_b = "rider.head",
                          .elongation = elongation,
                          .stiffness = 2000,
                          .damping = 3});
    contacts = ContactSet({contact_along_x(model, "mass.head", "", 0.25, law)});
  }
  std::vector<ContactExtremes::Ranges> extremes(const std::string &method, double tolerance,
                                                bool in_steps) const {
    Trajectory trajectory(model, contacts, {.method = method, .relative_tolerance = tolerance});
    trajectory.start(0, Vector::Zero(2), Vector::Constant(2, 0.5));
    ContactExtremes seen(model, in_steps);
    trajectory.advance(20, seen);
    return seen.contacts;
  }
  Model model;
  ContactSet contacts;
};

// Of the larger of the two ends.
double difference(const ValueRange &one, const ValueRange &other) {
  return std::max(std::abs(one.minimum - other.minimum), std::abs(one.maximum - other.maximum)) /
         other.peak();
}

// The same motion, whose contacts are shown in steps: what is seen of it does not change it.
// Polynomials do not end like accelerations of what touches.
TEST(CollocatedContacts, HaveTheExtremeValuesOfTheirSteps) {
  for (const auto &law : laws()) {
    const Carrier carrier(law);
    const auto direct = carrier.extremes("exact", 1e-9, false);
    const auto steps = carrier.extremes("exact", 1e-9, true);
    ASSERT_EQ(direct.size(), steps.size()) << law->name();
    EXPECT_GT(direct.size(), 5U);
    for (std::size_t i = 0; i < direct.size(); ++i)
      for (std::size_t k = 0; k + 1 < direct[i].size(); ++k)
        EXPECT_LT(difference(direct[i][k], steps[i][k]), k == 2 ? 1e-5 : 1e-8)
            << law->name() << ", contact " << i << ", quantity " << k;
    for (std::size_t i = 0; i < direct.size(); ++i)
      EXPECT_NEAR(direct[i].back().maximum / steps[i].back().maximum, 1, 1e-8);
  }
}

// Steps at a much smaller tolerance, as far as both are still the same motion: each contact makes a
// few times more of what they differ by. Speeds of approach differ by 1e-8 of the motion's speed,
// more of that of a weak contact. The accelerations of what touches are no polynomials where the
// force begins with an infinite rate.
TEST(CollocatedContacts, HaveTheExtremeValuesOfTheMotion) {
  for (const auto &law : laws()) {
    const Carrier carrier(law);
    const auto direct = carrier.extremes("exact", 1e-10, false);
    const auto steps = carrier.extremes("rk", 1e-13, true);
    ASSERT_EQ(direct.size(), steps.size()) << law->name();
    constexpr std::size_t first_contacts = 8;
    ASSERT_GE(direct.size(), first_contacts);
    const double of_acceleration = law->power_law() ? 1e-7 : 1e-5;
    double largest = 0;
    for (const ContactExtremes::Ranges &of : steps)
      largest = std::max(largest, of.back().maximum);
    for (std::size_t i = 0; i < first_contacts; ++i) {
      for (std::size_t k = 0; k + 1 < direct[i].size(); ++k)
        EXPECT_LT(difference(direct[i][k], steps[i][k]) * steps[i].back().maximum / largest,
                  k == 2 ? of_acceleration : 1e-7)
            << law->name() << ", contact " << i << ", quantity " << k;
      EXPECT_NEAR(direct[i].back().maximum, steps[i].back().maximum, 1e-7 * largest);
    }
  }
}

} // namespace collocated_contacts_tests
} // namespace vibroimpact::motion
