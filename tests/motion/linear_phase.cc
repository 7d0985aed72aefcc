// Exact motions of linear phases against closed forms: free and forced oscillators with every kind
// of damping, resonance, defective systems, internal states.
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "model/piecewise_function.h"
#include "motion/path/trajectory.h"
#include "motion/phase/exact_phases.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace vibroimpact::motion {
namespace linear_phase_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::single_mass;

class NoObserver : public Observer {};

Model forced_mass(double mass, double stiffness, double damping, double amplitude, double omega) {
  Model model({single_mass("block", mass, stiffness, damping)});
  if (amplitude != 0)
    model.add_force("force", std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0.3),
                    {.body = 0, .point = 0}, Vector3::UnitX());
  return model;
}

struct Motion {
  Vector state;
  Accuracy accuracy;
};

Motion motion_of(const Model &model, double q, double v, double duration, double maximum_step = 0) {
  const ContactSet contacts(std::vector<ContactPair>{});
  Settings settings;
  settings.maximum_step = maximum_step;
  Trajectory trajectory(model, contacts, settings);
  NoObserver nobody;
  trajectory.start(0, Vector::Constant(1, q), Vector::Constant(1, v));
  trajectory.advance(duration, nobody);
  return {trajectory.state(), trajectory.accuracy()};
}

// m q'' + c q' + k q = 0 with m = 1: complex roots r1, r2 of r^2 + c r + k.
double free_motion(double damping, double stiffness, double q, double v, double t) {
  using Complex = std::complex<double>;
  const Complex root = std::sqrt(Complex(damping * damping / 4 - stiffness));
  const double rate = v + damping / 2 * q;
  if (std::abs(root) == 0)
    return (q + rate * t) * std::exp(-damping / 2 * t);
  const Complex slow = 0.5 * (q + rate / root) * std::exp((-damping / 2 + root) * t);
  const Complex fast = 0.5 * (q - rate / root) * std::exp((-damping / 2 - root) * t);
  return (slow + fast).real();
}

TEST(LinearPhaseTest, FreeOscillatorOfEveryDamping) {
  const double stiffness = 400;
  // undamped, light, critical (defective), next to critical, overdamped, stiff
  for (const double damping : {0.0, 2.0, 40.0, 40.0 * (1 + 1e-12), 40.0001, 100.0, 4000.0}) {
    const Motion motion = motion_of(forced_mass(1, stiffness, damping, 0, 1), 0.01, -0.3, 0.7);
    EXPECT_NEAR(motion.state[0], free_motion(damping, stiffness, 0.01, -0.3, 0.7), 1e-13)
        << damping;
    EXPECT_LT(motion.accuracy.energy_residual, 1e-10) << damping;
  }
}

TEST(LinearPhaseTest, FreeMassUnderItsWeightAndAForce) {
  Model model({single_mass("block", 2, 0, 0)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 3, 7, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const double t = 1.3;
  // 2 q'' = 3 sin 7 t
  const Motion motion = motion_of(model, 0.1, -0.2, t);
  EXPECT_NEAR(motion.state[0], 0.1 + (-0.2 + 1.5 / 7) * t - 1.5 / 49 * std::sin(7 * t), 1e-14);
  EXPECT_NEAR(motion.state[1], -0.2 + 1.5 / 7 * (1 - std::cos(7 * t)), 1e-14);
  EXPECT_LT(motion.accuracy.energy_residual, 1e-10);
}

// q'' + w^2 q = a sin(w t): q = a / (2 w^2) (sin(w t) - w t cos(w t)), also next to resonance.
TEST(LinearPhaseTest, Resonance) {
  const double omega = 20;
  const double a = 5;
  const double t = 2;
  for (const double detuning : {0.0, 1e-13, 1e-9, 1e-6}) {
    const double forcing = omega * (1 + detuning);
    Model model({single_mass("block", 1, omega * omega, 0)});
    model.add_force("force", std::make_shared<Harmonic>(Given::displacement, a, forcing, 0),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    const Motion motion = motion_of(model, 0, 0, t);
    // By the midpoint d = (forcing - omega) / 2:  sin(f t) - (f / w) sin(w t) over w^2 - f^2.
    const double d = omega * detuning / 2;
    const double s = omega + d;
    const double sine_over_d = d == 0 ? t : std::sin(d * t) / d;
    // sin f t - sin w t = 2 cos(s t) sin(d t);  (1 - f / w) sin w t = -2 d / w sin w t
    const double numerator = 2 * std::cos(s * t) * sine_over_d - 2 / omega * std::sin(omega * t);
    EXPECT_NEAR(motion.state[0], -a * numerator / (4 * s), 1e-11) << detuning;
    EXPECT_LT(motion.accuracy.energy_residual, 1e-10) << detuning;
  }
}

TEST(LinearPhaseTest, ForcedResponseDoesNotDependOnTheSteps) {
  const Model model = forced_mass(2, 800, 3, 10, 17);
  const Motion natural = motion_of(model, 0.01, 0.1, 2.5);
  for (const double step : {0.02, 0.007, 0.001}) {
    const Motion limited = motion_of(model, 0.01, 0.1, 2.5, step);
    EXPECT_GE(limited.accuracy.steps, 2.5 / step - 1);
    EXPECT_LT((limited.state.head(2) - natural.state.head(2)).norm(), 1e-13) << step;
    // The integrals of energies as well.
    EXPECT_NEAR(limited.state[2], natural.state[2], 1e-10 * std::abs(natural.state[2])) << step;
    EXPECT_NEAR(limited.state[4], natural.state[4], 1e-10 * std::abs(natural.state[4])) << step;
  }
}

// Two kinds of stop at once on one mass; a compressed Kelvin-Voigt bumper recovers by exp(-k t /
// c).
TEST(LinearPhaseTest, SeveralContactsWithInternalStates) {
  const Model model({single_mass("block", 1, 100, 0.5)});
  ContactPair relaxing =
      contact_along_x(model, "block.head", "", 1.0, std::make_shared<KelvinVoigtBumper>(50, 5));
  ContactPair spring =
      contact_along_x(model, "block.head", "", -0.02, std::make_shared<BilinearStop>(300, 1.5));
  spring.accept_initial_penetration = true;
  const ContactSet contacts({relaxing, spring});
  Trajectory trajectory(model, contacts, {});
  NoObserver nobody;
  MotionState from{.time = 0, .physical = Vector::Zero(3)};
  from.physical << -0.014, 0.02, 0.3;
  trajectory.start(from);
  const double t = 0.2;
  trajectory.advance(t, nobody);
  // q'' + 2 q' + 400 q = -300 * 0.02: about q = -0.015.
  EXPECT_NEAR(trajectory.state()[0], -0.015 + free_motion(2, 400, 0.001, 0.02, t), 1e-14);
  EXPECT_NEAR(trajectory.state()[2], 0.3 * std::exp(-10 * t), 1e-14);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-10);
}

// While a Kelvin-Voigt bumper is pushed in, its compression follows the mass: an eigenvalue of
// zero, which the constant of the clearance does not drive, so that the response to it is a rest.
TEST(LinearPhaseTest, ConstantThatDoesNotDriveAModeAtRest) {
  const Model model({single_mass("block", 1, 1, 0.2)});
  const ContactSet contacts(
      {contact_along_x(model, "block.head", "", 0.25, std::make_shared<KelvinVoigtBumper>(5, 1))});
  Equations equations(model, contacts);
  equations.set_mode(0, 1);
  ExactPhases phases(equations, Settings{});
  ASSERT_TRUE(phases.take_sources(0));
  LinearPhase &known = *phases.present();
  ASSERT_FALSE(known.system().constant().isZero(0));
  EXPECT_FALSE(known.phase().has_dense());
  const Vector rest = known.phase().columns().col(known.phase().n_modes()).head(3);
  EXPECT_LT((known.system().matrix() * rest + known.system().constant()).norm(), 1e-14);
}

// Between the ends of steps displacements, velocities, accelerations and internal states keep the
// tolerance, relative to their own size.
TEST(LinearPhaseTest, DenseOutputKeepsTheTolerance) {
  class Compare : public Observer {
  public:
    explicit Compare(const Model &model)
        : along_(model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), true)) {}
    void step(const StepView &view) override {
      ++steps;
      const Bernstein acceleration = view.acceleration(along_);
      const Bernstein velocity = view.velocity(along_);
      for (int i = 0; i <= 20; ++i) {
        const double tau = i / 20.0;
        const double t = view.start() + tau * view.length();
        const double q = free_motion(2, 400, 0.3, -1, t);
        const double v = free_motion(2, 400, -1, -400 * 0.3 + 2, t);
        largest[0] = std::max(largest[0], std::abs(view.coordinate(0)(tau) - q));
        largest[1] = std::max(largest[1], std::abs(velocity(tau) - v));
        largest[2] = std::max(largest[2], std::abs(acceleration(tau) + 2 * v + 400 * q));
        largest[3] =
            std::max(largest[3], std::abs(view.internal(0)(tau) - 0.3 * std::exp(-300 * t)));
      }
    }
    std::array<double, 4> largest{};
    long steps = 0;

  private:
    Projection along_;
  };
  const Model model({single_mass("block", 1, 400, 2)});
  const ContactSet contacts({contact_along_x(model, "block.head", "", 10.0,
                                             std::make_shared<KelvinVoigtBumper>(1500, 5))});
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-12}) {
    Settings settings;
    settings.relative_tolerance = tolerance;
    Trajectory trajectory(model, contacts, settings);
    MotionState from{.time = 0, .physical = Vector::Zero(3)};
    from.physical << 0.3, -1, 0.3;
    Compare compare(model);
    trajectory.start(from);
    trajectory.advance(1, compare);
    EXPECT_LT(compare.largest[0], tolerance * 0.31);
    EXPECT_LT(compare.largest[1], tolerance * 6.2);
    EXPECT_LT(compare.largest[2], tolerance * 124);
    EXPECT_LT(compare.largest[3], tolerance * 0.31);
    // It is not bought by tiny steps: one second is 3 periods, and 300 decay times.
    EXPECT_LT(compare.steps, tolerance > 1e-10 ? 100 : 200);
  }
}

// A free mass and two stops that relax alike: three zeros and a double decay, for which pieces of
// the length of free flight overflow. The touch is found, observed or not.
TEST(LinearPhaseTest, FreeMassBetweenStopsThatRelaxAlike) {
  const Model model({single_mass("block", 3, 0, 0)});
  const auto stop = std::make_shared<KelvinVoigtBumper>(3e5, 285);
  ContactPair right = contact_along_x(model, "block.head", "", 0.01, stop);
  ContactPair left = right;
  left.gap.row *= -1;
  const ContactSet contacts({right, left});
  for (const bool observed : {true, false}) {
    Trajectory trajectory(model, contacts, {});
    NoObserver nobody;
    trajectory.start(0, Vector::Zero(1), Vector::Constant(1, 0.4));
    if (observed)
      trajectory.advance(0.026, nobody);
    else
      trajectory.advance(0.026);
    EXPECT_EQ(trajectory.accuracy().events, 1);
    // m q'' + c q' + k (q - clearance) = 0 since t = clearance / speed
    EXPECT_NEAR(trajectory.state()[0], 0.01 + free_motion(285.0 / 3, 1e5, 0, 0.4, 1e-3), 1e-14);
  }
  // Equal real exponents do not need each other.
  Equations equations(model, contacts);
  const ModalForm form(LinearSystem(equations).matrix());
  EXPECT_EQ(std::count_if(form.blocks().begin(), form.blocks().end(),
                          [](const ModalBlock &block) { return block.kind == BlockKind::real; }),
            2);
}

// Six masses of which one meets a dashpot that leaves it no vibration: eight groups before, nine
// after the change, beyond the block of eight that arrays are padded to.
TEST(LinearPhaseTest, AChangeToAPhaseOfMoreGroups) {
  std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
  for (int i = 0; i < 6; ++i)
    bodies.push_back(single_mass("block" + std::to_string(i), 1, 100 + 37 * i, 0.5));
  Model model(std::move(bodies));
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 20, 7, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  const ContactSet contacts(
      {contact_along_x(model, "block0.head", "", 0.05, std::make_shared<BilinearStop>(1e3, 1e3))});
  Vector end[2];
  for (const bool exact : {true, false}) {
    Settings settings;
    settings.method = exact ? "exact" : "rk";
    settings.relative_tolerance = 1e-11;
    Trajectory trajectory(model, contacts, settings);
    trajectory.start(0, Vector::Constant(6, 0.01), Vector::Zero(6));
    trajectory.advance(3);
    EXPECT_GT(trajectory.accuracy().events, 2);
    end[exact ? 0 : 1] = trajectory.state().head(12);
  }
  EXPECT_LT((end[0] - end[1]).norm(), 1e-8);
}

// Free bodies, critical damping and resonance with an observer that must see steps: energies by the
// closed form of dense blocks, in few steps however fast another body vibrates.
TEST(LinearPhaseTest, RecordedFreeBodyBesideAFastOne) {
  class Count : public Observer {
  public:
    void step(const StepView & /*view*/) override { ++steps; }
    long steps = 0;
  };
  Model model({single_mass("free", 2, 0, 0.3), single_mass("fast", 1, 1e8, 0)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 3, 7, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  model.add_force("load", make_constant(Given::displacement, 1), {.body = 0, .point = 0},
                  Vector3::UnitX());
  const ContactSet none;
  Trajectory trajectory(model, none, {});
  Count count;
  trajectory.start(0, Eigen::Vector2d(0, 1e-9), Eigen::Vector2d(0.2, 0));
  trajectory.advance(2, count);
  const StateLayout &layout = trajectory.layout();
  const double kinetic = trajectory.state()[2] * trajectory.state()[2];
  const double work = trajectory.state()[layout.input_work()];
  const double lost = trajectory.state()[layout.damping_work()];
  EXPECT_NEAR(kinetic - 0.04, work - lost, 1e-12 * work);
  EXPECT_LT(trajectory.accuracy().energy_residual, 1e-12);
}

} // namespace linear_phase_tests
} // namespace vibroimpact::motion
