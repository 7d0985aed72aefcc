// Deviations through a contact of the whole program: in closed form, and integrated beside the
// motion.
#include "motion/variation/contact_deviations.h"

#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kuwabara_kono.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace contact_deviations_tests {

// The motion from the first touch to the release.
class FirstContact : public Observer {
public:
  void event(const ContactEvent &event) override {
    if (part.from_event && !part.to_event) {
      part.end = event.time;
      part.end_state = *event.state;
      part.to_event = true;
    } else if (!part.from_event) {
      part.start = event.time;
      part.start_state = *event.state;
      part.from_event = true;
    }
  }
  SmoothPart part;
};

struct Passed {
  Matrix columns;
  double divergence = 0;
};

// Two masses on springs, the first of them driven, that meet across a gap.
class ContactDeviations
    : public ::testing::TestWithParam<std::shared_ptr<const contact::ContactLaw>> {
protected:
  ContactDeviations()
      : model_({testing::single_mass("a", 1, 100, 1), testing::single_mass("b", 2, 1500, 2)}) {
    model_.add_force("force",
                     std::make_shared<model::Harmonic>(model::Given::displacement, 3, 9, 0.3),
                     {.body = 0, .point = 0}, Vector3::UnitX());
    contacts_ = contact::ContactSet(
        {testing::contact_along_x(model_, "a.head", "b.head", 0.01, GetParam())});
  }
  SmoothPart first_contact() {
    Settings settings;
    settings.relative_tolerance = 1e-12;
    settings.event_tolerance = 1e-16;
    Trajectory trajectory(model_, contacts_, settings);
    FirstContact observer;
    trajectory.start(0, Vector::Zero(2), Vector{{0.3, 0}});
    trajectory.advance(1, observer);
    EXPECT_TRUE(observer.part.to_event);
    return observer.part;
  }
  Equations in_contact() const {
    Equations equations(model_, contacts_);
    equations.set_source_break(std::numeric_limits<double>::infinity());
    equations.set_mode(0, 1);
    return equations;
  }

  model::Model model_;
  contact::ContactSet contacts_;
};

TEST_P(ContactDeviations, AgreeWithIntegrationBesideTheMotion) {
  const SmoothPart part = first_contact();
  Equations equations = in_contact();
  ASSERT_EQ(contact_episode(equations), 0u);
  ExactPhases phases(equations, Settings());
  Passed closed{.columns = Matrix::Identity(4, 4)}, integrated = closed;
  const std::optional<double> divergence =
      pass_contact_episode(part, 0, equations, phases, 1e-11, closed.columns);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(equations.modes()[0], 1);
  const VariationAccuracy accuracy{.scale = Vector{{300, 300, 1, 1}}, .tolerance = 1e-12};
  integrated.divergence =
      integrate_beside(part, equations, {}, accuracy, nullptr, integrated.columns);
  EXPECT_NEAR(*divergence, integrated.divergence, 1e-9);
  for (Index j = 0; j < 4; ++j) {
    const Vector difference =
        accuracy.scale.cwiseProduct(closed.columns.col(j) - integrated.columns.col(j));
    EXPECT_LT(difference.norm(),
              1e-9 * accuracy.scale.cwiseProduct(integrated.columns.col(j)).norm())
        << "column " << j;
  }
}

TEST_P(ContactDeviations, NeedTouchAndRelease) {
  SmoothPart part = first_contact();
  Equations equations = in_contact();
  ExactPhases phases(equations, Settings());
  Matrix columns = Matrix::Identity(4, 4);
  part.to_event = false;
  EXPECT_FALSE(pass_contact_episode(part, 0, equations, phases, 1e-11, columns));
  part.to_event = true;
  part.end = 0.5 * (part.start + part.end);
  EXPECT_FALSE(pass_contact_episode(part, 0, equations, phases, 1e-11, columns));
  EXPECT_TRUE(columns.isIdentity(0));
}

const contact::HertzConstants constants{.stiffness = 1e7, .exponent = 1.5};
INSTANTIATE_TEST_SUITE_P(Laws, ContactDeviations,
                         ::testing::Values(std::make_shared<contact::Hertz>(constants),
                                           contact::HuntCrossley::with_dissipation(constants, 0.8),
                                           std::make_shared<contact::KuwabaraKono>(1e7, 5e-4)));

} // namespace contact_deviations_tests
} // namespace vibroimpact::motion
