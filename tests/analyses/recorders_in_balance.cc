// What different recorders tell of one motion fits together: momentum, velocities and impulses over
// a window that is no whole number of periods, on a shaken floor, against a stop, with a dashpot.
#include "analyses/recorders/energy.h"
#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/forces.h"
#include "analyses/recorders/impacts.h"
#include "analyses/recorders/statistics.h"
#include "contact/laws/kelvin_voigt.h"
#include "model/piecewise_function.h"
#include "model/side.h"
#include "model/system_damping.h"
#include "support/planar_models.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vibroimpact::analyses {
namespace recorders_in_balance_tests {

using namespace model;
using testing::recorded;
using testing::value_of;

constexpr double mass = 2, weight = 7, end = 2.345;
constexpr double floor_amplitude = 0.02, omega = 11;

System shaken_block() {
  Model model({testing::single_mass("block", mass, 300, 4)});
  model.add_base_motion(
      "floor", std::make_shared<Harmonic>(Given::displacement, floor_amplitude, omega, 0.4), {0},
      Vector3::UnitX());
  model.add_force("weight", make_constant(Given::displacement, weight), {}, Vector3::UnitX());
  model.add_connection({.name = "anchor",
                        .side_a = "block.head",
                        .side_b = "ground",
                        .elongation = model.displacement({}, -Vector3::UnitX(), true),
                        .stiffness = 50,
                        .damping = 3});
  const contact::ContactPair stop = testing::contact_along_x(
      model, "block.head", "", 0.03, std::make_shared<contact::KelvinVoigt>(5e3, 20));
  return testing::system_of(std::move(model), contact::ContactSet({stop}));
}

const Window window{.start = 0, .end = end};
const std::string head = "point/block.head/";

struct Ends {
  double displacement, velocity; // of the block relative to the floor, and in space
  double floor_displacement, floor_velocity;
};

Ends at_the_end(const System &system) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  trajectory.advance(end);
  return {trajectory.state()[0], trajectory.state()[1],
          floor_amplitude * (std::sin(omega * end + 0.4) - std::sin(0.4)),
          floor_amplitude * omega * (std::cos(omega * end + 0.4) - std::cos(0.4))};
}

TEST(RecordersInBalanceTest, MeanRatesAreTheChangesOverTheWindow) {
  const System system = shaken_block();
  const Ends ends = at_the_end(system);
  const PointResult result = recorded<Statistics>(system, window, ObservedSelection{});
  EXPECT_NEAR(value_of(result, head + "velocity_x/mean"), ends.displacement / end, 1e-9);
  EXPECT_NEAR(value_of(result, head + "acceleration_x/mean"),
              (ends.velocity + ends.floor_velocity) / end, 1e-7);
}

// m a = weight - force on floor and ground - force on the stop; in the mean as at every instant.
TEST(RecordersInBalanceTest, MeanForcesChangeTheMomentum) {
  const System system = shaken_block();
  const PointResult motion = recorded<Statistics>(system, window, ObservedSelection{});
  const PointResult forces = recorded<Forces>(system, window);
  const double on_floor = value_of(forces, "body/block/base_force_x/mean");
  const double on_stop = value_of(motion, "contact/heads/normal_force/mean");
  EXPECT_GT(on_stop, 0.1);
  EXPECT_NEAR(mass * value_of(motion, head + "acceleration_x/mean"), weight - on_floor - on_stop,
              1e-6);
  // The anchor's tension by its closed form in the mean of what it sees.
  EXPECT_NEAR(
      std::abs(value_of(forces, "connection/anchor/force/mean")),
      std::abs(50 * value_of(motion, head + "absolute_displacement_x/mean") +
               3 * (at_the_end(system).displacement + at_the_end(system).floor_displacement) / end),
      1e-7);
}

// The impulses of all impacts together are the mean force on the stop times the window; the time in
// contact and the deepest overlap are those that the gap shows.
TEST(RecordersInBalanceTest, ImpactsAddUpToTheForceOnTheStop) {
  const System system = shaken_block();
  const PointResult impacts = recorded<Impacts>(system, window);
  const PointResult motion = recorded<Statistics>(system, window, ObservedSelection{});
  const PointResult extremes = recorded<ExtremeValues>(system, window, ObservedSelection{});
  const std::string stop = "contact/heads/";
  const double count = value_of(impacts, stop + "impacts");
  EXPECT_GT(count, 2);
  EXPECT_NEAR(count * value_of(impacts, stop + "impulse/mean"),
              value_of(motion, stop + "normal_force/mean") * end, 1e-7);
  EXPECT_NEAR(count * value_of(impacts, stop + "contact_duration/mean"),
              value_of(impacts, stop + "contact_fraction") * end, 1e-9);
  EXPECT_NEAR(value_of(impacts, stop + "penetration/maximum"),
              -value_of(extremes, stop + "gap/minimum"), 1e-9);
  EXPECT_NEAR(value_of(impacts, stop + "peak_force/maximum"),
              value_of(extremes, stop + "normal_force/maximum"), 1e-6);
  // The gap is the clearance less the displacement in space.
  EXPECT_NEAR(value_of(extremes, stop + "gap/minimum"),
              0.03 - value_of(extremes, head + "absolute_displacement_x/maximum"), 1e-9);
}

TEST(RecordersInBalanceTest, SquaresAreThoseOfMeanAndScatter) {
  const PointResult result = recorded<Statistics>(shaken_block(), window, ObservedSelection{});
  for (const std::string name : {"displacement_x", "velocity_x", "acceleration_x"}) {
    const double mean = value_of(result, head + name + "/mean");
    const double scatter = value_of(result, head + name + "/rms_about_mean");
    const double rms = value_of(result, head + name + "/rms");
    EXPECT_NEAR(rms * rms, mean * mean + scatter * scatter, 1e-9 * rms * rms) << name;
  }
}

// Two floors, the upper one on the lower one, which stands on the shaken base and leans on the
// ground; every mode is damped.
System shaken_floors() {
  Model model({testing::single_mass("lower", 3, 400, 0), testing::single_mass("upper", 2, 0, 1)});
  model.add_base_motion(
      "floor", std::make_shared<Harmonic>(Given::displacement, floor_amplitude, omega, 0.4), {0, 1},
      Vector3::UnitX());
  const auto connect = [&](const std::string &a, const std::string &b, double stiffness) {
    model.add_connection(
        {.name = a + " to " + b,
         .side_a = a + ".head",
         .side_b = b,
         .elongation = relative_displacement({.a = a + ".head", .b = b}, Vector3::UnitX(), model),
         .stiffness = stiffness});
  };
  connect("lower", "upper.head", 250);
  connect("lower", "ground", 60);
  const auto root = std::make_shared<parameters::Section>("", "");
  declare_system_damping(*root);
  add_system_damping(parameters::ParameterSet::parse(
                         root, "subsection System damping\nset Damping ratio = 0.05, 0.1\nend\n",
                         "test.prm", false)
                         ->root(),
                     model);
  return testing::system_of(std::move(model));
}

TEST(RecordersInBalanceTest, SystemDampingTakesEnergyAndPushesTheBase) {
  const System system = shaken_floors();
  const PointResult energy = recorded<Energy>(system, window);
  const double lost = value_of(energy, "system_damping/dissipated_energy");
  EXPECT_GT(lost, 0.1 * value_of(energy, "energy/damping_work"));
  EXPECT_NEAR(value_of(energy, "energy/residual"), 0, 2e-12 * lost);
  // The change of momentum is the impulse of the forces on both bases.
  const PointResult motion = recorded<Statistics>(system, window, ObservedSelection{});
  const PointResult forces = recorded<Forces>(system, window);
  const double inertia = 3 * value_of(motion, "point/lower.head/acceleration_x/mean") +
                         2 * value_of(motion, "point/upper.head/acceleration_x/mean");
  EXPECT_NEAR(inertia,
              -value_of(forces, "body/lower/base_force_x/mean") -
                  value_of(forces, "body/upper/base_force_x/mean"),
              1e-11 * std::abs(inertia));
}

// A mass on a shaken base, in a bearing that joins both directions and stands on the ground.
TEST(RecordersInBalanceTest, BearingsTakeEnergyAndPushTheGround) {
  Model model({testing::sled_body({.mass = mass, .kx = 300, .ky = 200})});
  model.add_base_motion(
      "floor", std::make_shared<Harmonic>(Given::displacement, floor_amplitude, omega, 0.4), {0},
      Vector3::UnitX());
  Bearing film{.name = "film",
               .side_a = "sled.head",
               .side_b = "ground",
               .elongation = {model.displacement({}, -Vector3::UnitX(), true),
                              model.displacement({}, -Vector3::UnitY(), true)}};
  film.stiffness << 50, 20, -15, 40;
  film.damping << 3, 1, 0.5, 2;
  model.add_bearing(film);
  const System system = testing::system_of(std::move(model));
  const PointResult energy = recorded<Energy>(system, window);
  const double lost = value_of(energy, "bearing/film/dissipated_energy");
  EXPECT_GT(lost, 0);
  EXPECT_EQ(value_of(energy, "energy/damping_work"), lost);
  EXPECT_NEAR(value_of(energy, "energy/residual"), 0, 2e-12 * lost);
  // Of the motion relative to the floor, and of what the bearing sees of the ground.
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  const auto stored = [&] {
    const ConstVectorView q(trajectory.state().data(), 3);
    const Eigen::Vector2d seen(system.model.value(film.elongation[0], trajectory.time(), q),
                               system.model.value(film.elongation[1], trajectory.time(), q));
    return (mass * trajectory.state().segment(3, 3).squaredNorm() + 300 * q[0] * q[0] +
            200 * q[1] * q[1] + seen.dot(film.stiffness * seen)) /
           2;
  };
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  const double before = stored();
  trajectory.advance(end);
  EXPECT_NEAR(value_of(energy, "energy/stored_change"), stored() - before, 1e-12 * lost);
  const PointResult motion = recorded<Statistics>(system, window, ObservedSelection{});
  const PointResult forces = recorded<Forces>(system, window);
  for (const std::string axis : {"x", "y"}) {
    const double inertia =
        mass * value_of(motion, "point/sled.head/acceleration_" + axis + "/mean");
    EXPECT_NEAR(inertia, -value_of(forces, "body/sled/base_force_" + axis + "/mean"),
                1e-11 * std::abs(inertia));
  }
  EXPECT_NE(value_of(forces, "bearing/film/second_force/mean"), 0);
}

} // namespace recorders_in_balance_tests
} // namespace vibroimpact::analyses
