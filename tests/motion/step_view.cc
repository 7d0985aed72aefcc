// Curves of a step that is so short that differences of its ends are rounding.
#include "motion/observer.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::motion {
namespace {

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

} // namespace
} // namespace vibroimpact::motion
