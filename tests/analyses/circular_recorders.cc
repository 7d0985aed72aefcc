// What is sampled of a contact in a circular gap: a particle that flies close past the middle of
// its ring, where gap and slip rate turn at once.
#include "analyses/recorders/sampler.h"
#include "contact/friction/viscous.h"
#include "support/circular_contacts.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::analyses {
namespace circular_recorders_tests {

using contact::LinearPenalty;

TEST(CircularRecorders, GapAndSlipRatePastTheMiddle) {
  model::Model model({testing::particle("ball", 1)});
  contact::ContactSet contacts(
      {testing::ring_about_z(model, "ball.head", "", 0.1, std::make_shared<LinearPenalty>(10),
                             std::make_shared<contact::Viscous>(1), 0.2)});
  const System system = testing::system_of(std::move(model), std::move(contacts));
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  const Eigen::Vector2d start(-0.09, 1e-4), speed(0.3, 0.02);
  trajectory.start(0, start, speed);
  constexpr std::size_t count = 500;
  const double interval = 0.5 / count;
  Sampler sampler(observables({.points = {}, .kinds = {"gap", "slip"}}, system), 0, interval,
                  count);
  trajectory.advance(0.5, sampler);
  const std::vector<double> &gap = sampler.values(0), &slip_rate = sampler.values(1);
  ASSERT_EQ(slip_rate.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d place = start + static_cast<double>(i) * interval * speed;
    EXPECT_NEAR(gap[i], 0.1 - place.norm(), 1e-15) << i;
    // u of the ring relative to the particle: -place; the normal is along place.
    const double turning = (place[1] * speed[0] - place[0] * speed[1]) / place.norm();
    EXPECT_NEAR(slip_rate[i], turning + 0.2, 1e-13) << i;
  }
}

} // namespace circular_recorders_tests
} // namespace vibroimpact::analyses
