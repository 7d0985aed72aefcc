// Lyapunov exponent, regime, sections and spectra of motions with known answers.
#include "analyses/recorders/lyapunov.h"
#include "analyses/recorders/regime.h"
#include "analyses/recorders/section.h"
#include "analyses/recorders/spectrum.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/signals/zeros.h"
#include "common/decompositions.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "support/lumped_models.h"
#include "support/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace recorders_of_character_tests {

using namespace contact;
using namespace motion;
using namespace model;
using testing::contact_along_x;
using testing::field;
using testing::record;
using testing::single_mass;
using testing::value;

constexpr double pi = std::numbers::pi;

// A mass on a spring, its force amplitude sin(omega t), and a stop; c = 2 zeta.
struct Forced {
  double zeta = 0.05, amplitude = 0, omega = 1;
  double clearance = 0, stop = 0; ///< no stop when it has no stiffness
  double displacement = 0, velocity = 0;

  System system() const {
    Model model({single_mass("block", 1, 1, 2 * zeta)});
    PointReference head;
    model.find_point("block.head", head);
    if (amplitude > 0)
      model.add_force("drive", std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0),
                      head, Vector3::UnitX());
    std::vector<ContactPair> pairs;
    if (stop > 0)
      pairs.push_back(contact_along_x(model, "block.head", "", clearance,
                                      std::make_shared<LinearPenalty>(stop)));
    for (ContactPair &pair : pairs)
      pair.accept_initial_penetration = true;
    return {.model = std::move(model),
            .contacts = ContactSet(std::move(pairs)),
            .integration = {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-13},
            .initial = {.displacement = Vector::Constant(1, displacement),
                        .velocity = Vector::Constant(1, velocity)}};
  }
  double period() const { return 2 * pi / omega; }
};

PointResult lyapunov(const Forced &forced, const LyapunovSettings &settings, double period,
                     long settling, long cycles) {
  const System system = forced.system();
  LyapunovRecorder recorder(settings);
  record(system, recorder, period, settling, cycles);
  PointResult result;
  recorder.add_fields(result);
  return result;
}

// Seen once per turn a deviation of the damped oscillator shrinks by exp(-zeta omega T) exactly.
TEST(RecordersOfCharacterTest, ExponentOfTheDampedOscillator) {
  const Forced free{.zeta = 0.08, .displacement = 1};
  const double turn = 2 * pi / std::sqrt(1 - 0.08 * 0.08);
  const PointResult result = lyapunov(free, {.blocks = 3, .tolerance = 1e-11}, turn, 0, 10);
  EXPECT_NEAR(value(result, "lyapunov/exponent"), -0.08, 1e-9);
  EXPECT_NEAR(value(result, "lyapunov/exponent_per_period"), -0.08 * turn, 1e-8);
  EXPECT_NEAR(value(result, "lyapunov/standard_error"), 0, 1e-9);
  EXPECT_EQ(field(result, "lyapunov/running_exponent").values.size(), 9u);
}

// Overdamped, the slow root is left: -zeta + sqrt(zeta^2 - 1).
TEST(RecordersOfCharacterTest, ExponentOfTheOverdampedOscillator) {
  const Forced free{.zeta = 1.5, .displacement = 1};
  const PointResult result = lyapunov(free, {.discarded_share = 0.5, .tolerance = 1e-11}, 1, 0, 40);
  EXPECT_NEAR(value(result, "lyapunov/exponent"), -1.5 + std::sqrt(1.25), 1e-8);
}

// The largest multiplier of the stroboscopic map about the periodic motion, by finite differences.
double floquet_exponent(const Forced &forced, const Vector &state) {
  const System system = forced.system();
  Trajectory trajectory(system.model, system.contacts, system.integration);
  const auto map = [&](const Vector &from) -> Vector {
    testing::Nobody nobody;
    trajectory.start({.time = 0, .physical = from});
    trajectory.advance(forced.period(), nobody);
    return trajectory.motion_state().physical;
  };
  constexpr double epsilon = 1e-5;
  Matrix monodromy(2, 2);
  for (Index j = 0; j < 2; ++j) {
    const Vector shift = epsilon * Vector::Unit(2, j);
    monodromy.col(j) = (map(state + shift) - map(state - shift)) / (2 * epsilon);
  }
  const double largest = eigenvalues(monodromy).cwiseAbs().maxCoeff();
  return std::log(largest) / forced.period();
}

TEST(RecordersOfCharacterTest, ExponentOfAPeriodicMotionIsItsFloquetExponent) {
  // Here the multipliers are real and different, so that the mean growth settles quickly.
  const Forced impacting{.zeta = 0.1, .amplitude = 1, .omega = 1.65, .clearance = 0.3, .stop = 30};
  const System system = impacting.system();
  RegimeRecorder regime(system, {});
  const MotionState end = record(system, regime, impacting.period(), 200, 40);
  PointResult result;
  regime.add_fields(result);
  ASSERT_EQ(value(result, "regime/class"), 1);
  ASSERT_EQ(value(result, "regime/period_multiple"), 1);
  EXPECT_EQ(value(result, "regime/impacts_per_repetition/heads"), 1);

  const PointResult exponent = lyapunov(impacting, {.discarded_share = 0.5, .tolerance = 1e-10},
                                        impacting.period(), 200, 400);
  const double floquet = floquet_exponent(impacting, end.physical);
  EXPECT_GT(floquet, -0.09); // a complex pair would have -zeta
  EXPECT_NEAR(value(exponent, "lyapunov/exponent"), floquet, 1e-6);
}

// A linear oscillator repeats with the force; while it still settles it is called settling.
TEST(RecordersOfCharacterTest, RegimesOfALinearOscillator) {
  const Forced linear{.zeta = 0.02, .amplitude = 1, .omega = 0.7, .displacement = 0.5};
  const System system = linear.system();
  for (const long settling : {2L, 300L}) {
    RegimeRecorder regime(system, {});
    record(system, regime, linear.period(), settling, 40);
    PointResult result;
    regime.add_fields(result);
    EXPECT_EQ(value(result, "regime/class"), settling == 2 ? 2 : 1);
    EXPECT_EQ(value(result, "regime/period_multiple"), settling == 2 ? 0 : 1);
    EXPECT_NEAR(value(result, "regime/exponent"), -0.02, 2e-3);
  }
}

// Without damping the free vibration stays beside the forced one: a torus.
TEST(RecordersOfCharacterTest, ATorusIsQuasiPeriodic) {
  const Forced torus{.zeta = 0, .amplitude = 1, .omega = 0.5 * std::sqrt(2.0), .displacement = 1};
  const System system = torus.system();
  RegimeRecorder regime(system, {});
  record(system, regime, torus.period(), 0, 200);
  PointResult result;
  regime.add_fields(result);
  EXPECT_EQ(value(result, "regime/class"), 3);
  RegimeRecorder without(system, {.exponent = false});
  record(system, without, torus.period(), 0, 200);
  PointResult unclassified;
  without.add_fields(unclassified);
  EXPECT_EQ(value(unclassified, "regime/class"), 0);
}

// The exponent of a torus is zero, but that of a finite window scatters about it. On either side
// of zero, within the threshold, it is none. The stop is always pressed, so that the mass turns
// faster in its phase plane than the scales of the states are made for.
TEST(RecordersOfCharacterTest, AnExponentWithinTheThresholdIsNone) {
  const Forced torus{
      .zeta = 0, .amplitude = 1, .omega = 0.5, .clearance = -50, .stop = 1, .displacement = -24};
  const System system = torus.system();
  int negative = 0;
  for (long cycles = 60; cycles < 76; ++cycles) {
    RegimeRecorder regime(system, {});
    record(system, regime, torus.period(), 0, cycles);
    PointResult result;
    regime.add_fields(result);
    EXPECT_EQ(value(result, "regime/class"), 3) << cycles;
    negative += value(result, "regime/exponent") < 0 ? 1 : 0;
  }
  EXPECT_GT(negative, 0);
}

// A free mass drifts away from where it would have been: deviations grow in proportion to time,
// which is no chaos in however short a window, and nothing is decided before the exponent has its
// error.
TEST(RecordersOfCharacterTest, AFreeMotionIsNeverChaotic) {
  const System system{.model = Model({single_mass("block", 1, 0, 0)}),
                      .contacts = {},
                      .integration = {},
                      .initial = {.displacement = Vector::Zero(1), .velocity = Vector::Ones(1)}};
  for (const long cycles : {2, 15, 21, 40, 100, 300}) {
    RegimeRecorder regime(system, {});
    record(system, regime, 1, 0, cycles);
    PointResult result;
    regime.add_fields(result);
    EXPECT_EQ(value(result, "regime/class"), cycles < 256 ? 5 : 3) << cycles;
    EXPECT_EQ(std::any_of(result.summary.begin(), result.summary.end(),
                          [](const SummaryLine &line) {
                            return line.label.name() == "regime.cycles_that_would_decide";
                          }),
              cycles < 256);
  }
}

// A stop that is hit in every period beside one that only goes on recovering, by less than 1e-9 of
// what the other one is compressed: the states of both together repeat.
TEST(RecordersOfCharacterTest, AnInternalStateAtRestBesideOneThatMoves) {
  const Forced forced{.zeta = 0.1, .amplitude = 1, .omega = 1.65};
  System system = forced.system();
  ContactPair hit = contact_along_x(system.model, "block.head", "", 0.3,
                                    std::make_shared<KelvinVoigtBumper>(30, 5));
  ContactPair far = contact_along_x(system.model, "block.head", "", 50,
                                    std::make_shared<KelvinVoigtBumper>(1, 1000));
  far.name = "far";
  system.contacts = ContactSet({hit, far});
  Trajectory trajectory(system.model, system.contacts, system.integration);
  testing::Nobody nobody;
  trajectory.start({.time = 0, .physical = Eigen::Vector4d(0, 0, 0, 1e-10)});
  trajectory.advance(200 * forced.period(), nobody);
  RegimeRecorder regime(system, {});
  regime.begin(periods_window(trajectory.time(), forced.period(), 20), trajectory);
  for (long cycle = 1; cycle <= 20; ++cycle) {
    trajectory.advance(static_cast<double>(200 + cycle) * forced.period(), regime);
    regime.period_end(cycle, trajectory);
  }
  PointResult result;
  regime.add_fields(result);
  EXPECT_EQ(value(result, "regime/class"), 1);
  EXPECT_EQ(value(result, "regime/period_multiple"), 1);
}

TEST(RecordersOfCharacterTest, AllZerosOfAPolynomial) {
  // Value 0, rate 1 at both ends with free accelerations: several zeros in one step.
  const Bernstein wave = Bernstein::quintic(1, {0.1, -1, 0}, {0.1, -1, 0});
  const std::vector<double> zeros = sign_changes(wave);
  ASSERT_EQ(zeros.size(), 2u);
  for (const double zero : zeros)
    EXPECT_NEAR(wave(zero), 0, 1e-15);
  EXPECT_TRUE(sign_changes(Bernstein(3)).empty());
  EXPECT_TRUE(sign_changes(Bernstein::cubic(1, {0, 1}, {2, 1})).empty()); // zero at the start
  EXPECT_TRUE(sign_changes(Bernstein::cubic(1, {0, -1}, {-2, -1})).empty());
}

// Steady forced vibration: the Poincare point is one, extrema are at the amplitude, orders known.
TEST(RecordersOfCharacterTest, SectionsAndOrdersOfAForcedVibration) {
  const Forced linear{.zeta = 0.2, .amplitude = 2, .omega = 1.3};
  const System system = linear.system();
  const std::complex<double> response =
      2.0 / std::complex<double>(1 - 1.3 * 1.3, 2 * 0.2 * 1.3); // of sin(omega t)
  SectionRecorder section(system, {.extrema = true, .maximum_samples = 7});
  record(system, section, linear.period(), 60, 10);
  PointResult result;
  section.add_fields(result);
  const std::string point = "point/block.head/";
  for (const double x : field(result, "section/period/" + point + "displacement_x").values)
    EXPECT_NEAR(x, response.imag(), 1e-8);
  for (const double v : field(result, "section/period/" + point + "velocity_x").values)
    EXPECT_NEAR(v, 1.3 * response.real(), 1e-8);
  const std::string extremum = "section/extremum/block.head/displacement_x/";
  for (const double x : field(result, extremum + point + "displacement_x").values)
    EXPECT_NEAR(std::abs(x), std::abs(response), 1e-8);
  EXPECT_EQ(field(result, extremum + "time").values.size(), 7u);
  EXPECT_EQ(value(result, extremum + "left_out"), 20 - 7);
  EXPECT_EQ(value(result, "section/period/left_out"), 3);
}

TEST(RecordersOfCharacterTest, SpectrumOfAForcedVibration) {
  const Forced linear{.zeta = 0.2, .amplitude = 2, .omega = 1.3};
  const System system = linear.system();
  const double size = 2 / std::abs(std::complex<double>(1 - 1.3 * 1.3, 2 * 0.2 * 1.3));
  Observable signal = observables({}, system).front();
  signal.path = "x";
  SpectrumRecorder spectrum({signal}, {.orders = 4, .highest_order = 8});
  record(system, spectrum, linear.period(), 60, 5);
  PointResult result;
  spectrum.add_fields(result);
  const std::vector<double> orders = field(result, "order_amplitude/x").values;
  EXPECT_NEAR(orders[0], size, 1e-8);
  EXPECT_NEAR(orders[1], 0, 1e-8);
  const std::vector<double> lines = field(result, "spectrum/x").values;
  EXPECT_EQ(lines.size(), 8u * 5 + 1);
  EXPECT_NEAR(lines[5], size, 1e-8);
  EXPECT_NEAR(lines[6], 0, 1e-8);
  EXPECT_NEAR(field(result, "spectrum/frequency").values[5], 1.3 / (2 * pi), 1e-12);
}

// Onsets of contact: the displacement is the clearance, one per period.
TEST(RecordersOfCharacterTest, SectionAtTheOnsetOfContact) {
  const Forced impacting{.zeta = 0.1, .amplitude = 1, .omega = 1.55, .clearance = 0.3, .stop = 30};
  const System system = impacting.system();
  SectionRecorder section(system, {.onsets = {0}, .gap_extrema = {0}, .maximum_samples = 100});
  record(system, section, impacting.period(), 200, 10);
  PointResult result;
  section.add_fields(result);
  const auto &onset = field(result, "section/onset/heads/point/block.head/displacement_x").values;
  ASSERT_EQ(onset.size(), 10u);
  for (const double x : onset)
    EXPECT_NEAR(x, 0.3, 1e-10);
  EXPECT_EQ(field(result, "section/gap_extremum/heads/time").values.size(), 20u);
}

} // namespace recorders_of_character_tests
} // namespace vibroimpact::analyses
