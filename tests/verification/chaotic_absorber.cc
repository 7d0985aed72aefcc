// Largest Lyapunov exponent of a chaotic motion with two-sided Hertz contact: a vibro-impact
// absorber on an oscillator under harmonic force. The exponent by the variational equation is held
// against the growth of the distance between two motions, and against figures found by
// other means.
//
// Primary structure 1000 kg, 39.5 kN/m, 452 N s/m, force 800 N cos(7.23 t); absorber 37.88 kg,
// 414.6 N/m, 40.65 N s/m, free between contacts 50 mm to the left and 24.7 mm to the right. The
// exponents 0.12 1/s (steel on both sides) and 0.31 1/s (a right stop of 21 MPa) come from an
// independent event-located computation.
#include "analyses/recorders/lyapunov.h"
#include "analyses/recorders/regime.h"
#include "analyses/sweeps/steadiness.h"
#include "contact/laws/hertz.h"
#include "support/lumped_models.h"
#include "support/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact {
namespace chaotic_absorber_tests {

using namespace analyses;
using namespace contact;
using namespace motion;
using namespace model;
using testing::contact_along_x;
using testing::value;

constexpr double omega = 7.23;
constexpr double period = 2 * std::numbers::pi / omega;
constexpr double steel = 1.541797e11; ///< [N/m^1.5]

System absorber(double right_stiffness) {
  Model model({testing::single_mass("primary", 1000, 3.95e4, 452),
               testing::single_mass("absorber", 37.88, 0, 0)});
  PointReference primary, mass;
  model.find_point("primary.head", primary);
  model.find_point("absorber.head", mass);
  model.add_force("drive",
                  std::make_shared<Harmonic>(Given::displacement, 800, omega, std::numbers::pi / 2),
                  primary, Vector3::UnitX());
  Projection elongation = model.displacement(mass, Vector3::UnitX(), true);
  elongation.row -= model.displacement(primary, Vector3::UnitX(), true).row;
  model.add_connection({.name = "link",
                        .side_a = "primary.head",
                        .side_b = "absorber.head",
                        .elongation = elongation,
                        .stiffness = 414.6,
                        .damping = 40.65});
  const auto hertz = [](double stiffness) {
    return std::make_shared<Hertz>(HertzConstants{.stiffness = stiffness, .exponent = 1.5});
  };
  ContactPair left = contact_along_x(model, "primary.head", "absorber.head", 0.05, hertz(steel));
  left.name = "left";
  ContactPair right = contact_along_x(model, "absorber.head", "primary.head", 0.0747 - 0.05,
                                      hertz(right_stiffness));
  right.name = "right";
  return {.model = std::move(model),
          .contacts = ContactSet({left, right}),
          .integration = {.relative_tolerance = 1e-12, .absolute_tolerance = 1e-15},
          .initial = {.displacement = Vector::Zero(2), .velocity = Vector::Zero(2)}};
}

// Follows the growth of the distance to a second motion, set back to a small one every period.
class TwoMotions : public Recorder {
public:
  explicit TwoMotions(const System &system)
      : second_(system.model, system.contacts, system.integration), growth_(0.1) {}

  void begin(const Window & /*window*/, const Trajectory &trajectory) override {
    scale_ = state_scale(trajectory.equations(), omega);
    deviation_ = scale_.cwiseInverse() * distance;
    set_back(trajectory);
  }
  void period_end(long /*cycle*/, const Trajectory &trajectory) override {
    testing::Nobody nobody;
    second_.advance(trajectory.time(), nobody);
    deviation_ = second_.motion_state().physical - trajectory.motion_state().physical;
    const double size = deviation_.cwiseProduct(scale_).cwiseAbs().maxCoeff();
    growth_.add(period, std::log(size / distance));
    deviation_ *= distance / size;
    set_back(trajectory);
  }
  void add_fields(const FieldWriter & /*result*/) const override {}
  double exponent() const { return growth_.exponent(); }

private:
  // Far above the errors of the integration, of which those by the usual absolute tolerance of
  // 1e-12 m would be a percent of the growth, and far below the penetrations of a hard contact.
  static constexpr double distance = 1e-8; ///< [m]: of displacements
  void set_back(const Trajectory &trajectory) {
    MotionState beside = trajectory.motion_state();
    beside.physical += deviation_;
    second_.start(beside);
  }

  Trajectory second_;
  Growth growth_;
  Vector scale_, deviation_;
};

struct Exponents {
  double variation = 0, error = 0, two_motions = 0, regime = 0;
};

Exponents exponents(double right_stiffness, long cycles) {
  const System system = absorber(right_stiffness);
  RegimeRecorder regime(system, {});
  TwoMotions two(system);
  class Both : public Recorder {
  public:
    Both(Recorder &a, Recorder &b) : a_(a), b_(b) {}
    void begin(const Window &window, const Trajectory &trajectory) override {
      a_.begin(window, trajectory);
      b_.begin(window, trajectory);
    }
    void step(const StepView &view) override { a_.step(view); }
    void event(const ContactEvent &event) override { a_.event(event); }
    void period_end(long cycle, const Trajectory &trajectory) override {
      a_.period_end(cycle, trajectory);
      b_.period_end(cycle, trajectory);
    }
    void add_fields(const FieldWriter &result) const override { a_.add_fields(result); }

  private:
    Recorder &a_, &b_;
  } both(regime, two);
  testing::record(system, both, period, 300, cycles);
  PointResult result;
  both.add_fields(result);
  EXPECT_EQ(value(result, "regime/period_multiple"), 0);
  // Exactly one impact on the left and two on the right in every period, chaotic or not.
  EXPECT_NEAR(value(result, "regime/impacts_per_period/left"), 1,
              2.0 / static_cast<double>(cycles));
  EXPECT_NEAR(value(result, "regime/impacts_per_period/right"), 2,
              2.0 / static_cast<double>(cycles));
  return {.variation = value(result, "regime/exponent"),
          .error = value(result, "regime/exponent_error"),
          .two_motions = two.exponent(),
          .regime = value(result, "regime/class")};
}

TEST(ChaoticAbsorberTest, SteelOnBothSides) {
  const Exponents found = exponents(steel, 2400); // the growth varies slowly here
  EXPECT_EQ(found.regime, 4);
  EXPECT_NEAR(found.variation, found.two_motions, 0.001 * found.variation);
  EXPECT_NEAR(found.variation, 0.12, 0.005 + 3 * found.error);
}

TEST(ChaoticAbsorberTest, SoftRightStop) {
  const Exponents found = exponents(3.0834e7, 600);
  EXPECT_EQ(found.regime, 4);
  EXPECT_NEAR(found.variation, found.two_motions, 0.001 * found.variation);
  EXPECT_NEAR(found.variation, 0.31, 0.005 + 3 * found.error);
}

} // namespace chaotic_absorber_tests
} // namespace vibroimpact
