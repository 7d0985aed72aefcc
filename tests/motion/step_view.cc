// Curves of a step that is so short that differences of its ends are rounding, and of forces that
// begin and end steeply.
#include "contact/laws/tsuji.h"
#include "motion/interval/observer.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace step_view_tests {

// x = 1000 + cos(w t) near t = 0.3: of a step of 1e-9 s neither the positions nor the velocities
// show an acceleration, but its ends do.
TEST(StepViewTest, AccelerationOverAVeryShortStep) {
  constexpr double omega = 5, instant = 0.3, length = 1e-9;
  const model::Model model({testing::single_mass("mass", 1, omega * omega, 0)});
  const contact::ContactSet none;
  const Equations equations(model, none);
  const auto at = [&](double time) {
    EndPoint point{.time = time,
                   .state = Vector::Zero(equations.layout().size()),
                   .rates = Vector::Zero(equations.layout().size()),
                   .higher = {},
                   .sources = {}};
    point.state.head(2) << 1000 + std::cos(omega * time), -omega * std::sin(omega * time);
    point.rates.head(2) << point.state[1], -omega * omega * std::cos(omega * time);
    return point;
  };
  const EndPoint start = at(instant);
  const EndPoint end = at(instant + length);
  const StepView view(equations, start, end);
  const Bernstein acceleration =
      view.acceleration(model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false));
  EXPECT_EQ(acceleration.start(), start.rates[1]);
  EXPECT_EQ(acceleration.end(), end.rates[1]);
  EXPECT_NEAR(acceleration(0.5), -omega * omega * std::cos(omega * instant), 1e-6);
}

class LargestAcceleration : public Observer {
public:
  explicit LargestAcceleration(model::Projection of) : of_(std::move(of)) {}
  void step(const StepView &view) override {
    const Bernstein curve = view.acceleration(of_);
    within = std::max({within, curve.maximum(), -curve.minimum()});
    at_ends = std::max({at_ends, std::abs(curve.start()), std::abs(curve.end())});
  }
  double within = 0, at_ends = 0;

private:
  model::Projection of_;
};

// Tsuji's force grows like u^(1/4), whose rate is infinite at both ends of the contact. Nothing but
// the force at its steps' ends, many in a contact, makes the acceleration of the mass; between them
// its peak is a little higher.
TEST(StepViewTest, AccelerationByAForceThatBeginsAndEndsSteeply) {
  const model::Model model({testing::single_mass("mass", 1, 1, 0)});
  const contact::ContactSet contacts({testing::contact_along_x(
      model, "mass.head", "", 0.1, std::make_shared<contact::Tsuji>(4e4, 40))});
  for (const double speed : {0.3, 1.0, 3.0}) {
    Settings settings;
    settings.relative_tolerance = 1e-9;
    Trajectory trajectory(model, contacts, settings);
    LargestAcceleration largest(
        model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false));
    trajectory.start(0, Vector::Zero(1), Vector::Constant(1, speed));
    trajectory.advance(5, largest);
    EXPECT_LT(largest.within, 1.05 * largest.at_ends) << speed;
  }
}

} // namespace step_view_tests
} // namespace vibroimpact::motion
