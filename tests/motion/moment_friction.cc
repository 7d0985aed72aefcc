// Friction that yields, in steps that no contact change ends: against the exact method.
#include "common/error.h"
#include "contact/friction/coulomb.h"
#include "contact/friction/frictional_law.h"
#include "contact/friction/spring_slider.h"
#include "contact/friction/viscous.h"
#include "support/beam_on_stops.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace moment_friction_tests {

using namespace contact;
using testing::BeamOnStops;

// The stops, one of them a belt, are rubbed along another combination of the coordinates.
ContactSet with_friction(const BeamOnStops &system, const model::Model &model,
                         std::shared_ptr<const TangentialLaw> friction) {
  std::vector<ContactPair> pairs = system.contacts(model).pairs();
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    TangentialDirection direction{.slip = pairs[c].gap, .surface_speed = c == 0 ? 0.02 : 0.0};
    for (Index k = 0; k < direction.slip.row.size(); ++k)
      direction.slip.row[k] = 0.3 * std::cos(static_cast<double>((c + 1) * (k + 1)));
    pairs[c].tangential.push_back(direction);
    pairs[c].law = std::make_shared<FrictionalLaw>(system.law, friction);
  }
  return ContactSet(std::move(pairs));
}

struct Seen {
  Vector state; ///< with all integrals
  Accuracy accuracy;
};

Seen move(const BeamOnStops &system, std::shared_ptr<const TangentialLaw> friction,
          const std::string &method, double tolerance, bool observed = true) {
  const model::Model model = system.model();
  const ContactSet contacts = with_friction(system, model, std::move(friction));
  Settings settings;
  settings.method = method;
  settings.relative_tolerance = tolerance;
  Trajectory trajectory(model, contacts, settings);
  trajectory.start(0, Vector::Zero(model.size()), Vector::Zero(model.size()));
  ImpactLog log(contacts, 0);
  if (observed)
    trajectory.advance(system.duration, log);
  else
    trajectory.advance(system.duration);
  return {.state = trajectory.state(), .accuracy = trajectory.accuracy()};
}

// Impulses, works of friction and ways are integrals of the state.
void expect_agreement(const BeamOnStops &system,
                      const std::shared_ptr<const TangentialLaw> &friction) {
  const double tolerance = 1e-9;
  const Seen exact = move(system, friction, "exact", 1e-12);
  const Seen found = move(system, friction, "moments", tolerance);
  EXPECT_GT(found.accuracy.moment_steps, 0);
  EXPECT_EQ(found.accuracy.moment_steps, found.accuracy.steps);
  EXPECT_EQ(found.accuracy.events, exact.accuracy.events);
  EXPECT_GE(exact.accuracy.events, 2 * system.stops);
  EXPECT_LT(found.accuracy.energy_residual, tolerance);
  const model::Model model = system.model();
  EXPECT_LT(testing::energy_difference(system, found.state.head(2 * model.size()),
                                       exact.state.head(2 * model.size())),
            tolerance);
  const auto integrals = [&](Vector state) { // but for that of the absolute power
    state[state.size() - 3 - 5 * system.stops + 1] = 0;
    return Vector(state.tail(state.size() - 2 * model.size()));
  };
  EXPECT_EQ(exact.accuracy.moment_steps, 0);
  const Vector expected = integrals(exact.state);
  EXPECT_LT((integrals(found.state) - expected).cwiseAbs().maxCoeff(),
            1e-7 * expected.cwiseAbs().maxCoeff());
  const Index physical =
      2 * model.size() + (friction->internal_states().empty() ? 0 : system.stops);
  const Seen unobserved = move(system, friction, "moments", tolerance, false);
  EXPECT_EQ(unobserved.accuracy.events, found.accuracy.events);
  EXPECT_LT((unobserved.state.head(physical) - found.state.head(physical)).norm(),
            tolerance * found.state.head(physical).norm());
}

TEST(MomentFrictionTest, Viscous) {
  const BeamOnStops system{.stops = 16, .law = std::make_shared<LinearPenalty>(1.25e5)};
  expect_agreement(system, std::make_shared<contact::Viscous>(20));
}

TEST(MomentFrictionTest, ViscousBesideADashpot) {
  const BeamOnStops system{.stops = 8, .law = std::make_shared<KelvinVoigt>(2.5e5, 25)};
  expect_agreement(system, std::make_shared<contact::Viscous>(40));
}

// Sliders stick, yield and turn; their springs relax where the sides part.
TEST(MomentFrictionTest, SpringSliders) {
  const BeamOnStops system{.stops = 16, .law = std::make_shared<LinearPenalty>(1.25e5)};
  expect_agreement(system, std::make_shared<SpringSlider>(6e4, 0.3, 0));
}

// Sides that stick need a force that no gap tells; a spring that relaxes, a state of its own.
TEST(MomentFrictionTest, RefusesWhatSticksOrRelaxes) {
  const BeamOnStops system{.stops = 2, .law = std::make_shared<LinearPenalty>(1e6)};
  EXPECT_THROW(move(system, std::make_shared<Coulomb>(0.3, 0.3), "moments", 1e-9), InputError);
  EXPECT_THROW(move(system, std::make_shared<SpringSlider>(6e4, 0.3, 10), "moments", 1e-9),
               InputError);
}

} // namespace moment_friction_tests
} // namespace vibroimpact::motion
