// A damped oscillator between two Kelvin-Voigt bumpers under harmonic base acceleration: steady
// excursions against reference values of independent solvers, over clearances from 0.7 to 0 of the
// largest free displacement. All quantities are dimensionless: mass, stiffness and largest free
// amplitude are 1.
#include "contact/laws/kelvin_voigt_bumper.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::contact {
namespace two_kelvin_voigt_bumpers_tests {

using namespace motion;
using namespace model;

constexpr double damping_ratio = 0.1;
constexpr double stop_damping = 5; // times that of the oscillator

struct Point {
  double clearance, stiffness, frequency;                     ///< delta_0, lambda, beta
  double acceleration, displacement, force, stop_deformation; ///< normalised excursions
};

// Contact-free oscillator: amplitude of the ground that gives the largest displacement 1, and the
// largest absolute acceleration over the frequencies.
double ground_acceleration() {
  return 2 * damping_ratio * std::sqrt(1 - damping_ratio * damping_ratio);
}
double largest_free_acceleration() {
  const double d = 4 * damping_ratio * damping_ratio;
  const double r = (std::sqrt(1 + 2 * d) - 1) / d;
  return ground_acceleration() * std::sqrt((1 + d * r) / ((1 - r) * (1 - r) + d * r));
}

struct Excursion {
  double lowest = 0, highest = 0;
  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  double span() const { return highest - lowest; }
};

// One-sided values at the jumps of the force are the ends of the steps.
struct Extremes : Observer {
  Excursion displacement, acceleration, force_right, force_left, stop_right, stop_left;
  void step(const StepView &view) override {
    constexpr int samples = 512;
    const Bernstein position = view.coordinate(0);
    const Bernstein velocity = position.derivative();
    for (int i = 0; i <= samples; ++i) {
      const double tau = static_cast<double>(i) / samples;
      const double right = view.force(0, tau);
      const double left = view.force(1, tau);
      displacement.include(position(tau));
      acceleration.include(-2 * damping_ratio * velocity(tau) / view.length() - position(tau) -
                           right + left);
      force_right.include(right);
      force_left.include(left);
      stop_right.include(view.internal(0)(tau));
      stop_left.include(view.internal(1)(tau));
    }
  }
};

void check(const Point &point) {
  Model model({testing::single_mass("mass", 1, 1, 2 * damping_ratio)});
  PointReference head;
  model.find_point("mass.head", head);
  model.add_force(
      "ground",
      std::make_shared<Harmonic>(Given::displacement, -ground_acceleration(), point.frequency, 0),
      head, Vector3::UnitX());
  const auto law =
      std::make_shared<KelvinVoigtBumper>(point.stiffness, 2 * damping_ratio * stop_damping);
  ContactPair right = testing::contact_along_x(model, "mass.head", "", point.clearance, law);
  ContactPair left = right;
  left.gap.row *= -1;
  const ContactSet contacts({right, left});
  Trajectory trajectory(model, contacts, Settings{});
  const double period = 2 * std::numbers::pi / point.frequency;
  ImpactLog log(contacts, 0);
  trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  trajectory.advance(80 * period, log);
  log.clear();
  Extremes extremes;
  Observers observers({&log, &extremes});
  trajectory.advance(82 * period, observers);
  const std::string where = "clearance " + std::to_string(point.clearance) + ", stiffness " +
                            std::to_string(point.stiffness);
  const double span = 2 * largest_free_acceleration();
  EXPECT_NEAR(extremes.acceleration.span() / span, point.acceleration, 1e-6) << where;
  EXPECT_NEAR(extremes.displacement.span() / 2, point.displacement, 1e-6) << where;
  EXPECT_NEAR((extremes.force_right.highest + extremes.force_left.highest) / span, point.force,
              1e-6)
      << where;
  EXPECT_NEAR((extremes.stop_right.highest + extremes.stop_left.highest) / 2,
              point.stop_deformation, 1e-6)
      << where;
  EXPECT_EQ(log.begun(0), 2u) << where;
  EXPECT_EQ(log.begun(1), 2u) << where;
  // Contact, release, and end of leaving: three changes per impact, and no false ones.
  EXPECT_LE(trajectory.accuracy().events, 3 * 2 * 84) << where;
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-7) << where;
}

TEST(TwoKelvinVoigtBumpersTest, SteadyExcursionsAgreeWithReferenceValues) {
  check({0.7, 2, 1.05, 1.2355375, 0.7971071, 0.4572763, 0.0971071});
  check({0.7, 0.1, 1.02, 1.3055934, 0.8882803, 0.4308399, 0.1882803});
  check({0.4, 1, 0.9, 0.7525876, 0.4879760, 0.3000629, 0.0879760});
  check({0.4, 1, 1.1268, 1.0023835, 0.5559541, 0.5075283, 0.1559541});
  check({ground_acceleration(), 1, 1.2142, 0.7428957, 0.3685975, 0.4429727, 0.1696000});
  check({0.0657506, 0.1, 1.1, 0.9864602, 0.5289223, 0.5416541, 0.4631717});
  check({0.0657506, 1, 1.32, 0.5313850, 0.2317530, 0.3443299, 0.1660024});
}

// The mass rests between two stops that touch it from the start.
TEST(TwoKelvinVoigtBumpersTest, WithoutClearance) {
  check({0, 1, 1.4188, 0.4075957, 0.1573106, 0.2768695, 0.1573106});
}

} // namespace two_kelvin_voigt_bumpers_tests
} // namespace vibroimpact::contact
