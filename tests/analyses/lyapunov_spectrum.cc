// All Lyapunov exponents of motions with known answers, and their sum against the divergence.
#include "analyses/recorders/lyapunov.h"
#include "analyses/recorders/window_recording.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "support/lumped_models.h"
#include "support/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {
namespace lyapunov_spectrum_tests {

using namespace contact;
using namespace model;
using testing::contact_along_x;
using testing::field;
using testing::single_mass;
using testing::value;

constexpr double pi = std::numbers::pi;

// A unit mass on a spring, c = 2 zeta, its force amplitude sin(omega t), and a stop.
struct Oscillator {
  double zeta = 0, amplitude = 0, omega = 1;
  std::shared_ptr<const ContactLaw> stop = nullptr;
  double clearance = 0, displacement = 0, stiffness = 1;

  double period() const { return 2 * pi / omega; }
  System system() const {
    Model model({single_mass("block", 1, stiffness, 2 * zeta)});
    PointReference head;
    model.find_point("block.head", head);
    if (amplitude > 0)
      model.add_force("drive", std::make_shared<Harmonic>(Given::displacement, amplitude, omega, 0),
                      head, Vector3::UnitX());
    std::vector<ContactPair> pairs;
    if (stop)
      pairs.push_back(contact_along_x(model, "block.head", "", clearance, stop));
    return {.model = std::move(model),
            .contacts = ContactSet(std::move(pairs)),
            .integration = {.relative_tolerance = 1e-11},
            .initial = {.displacement = Vector::Constant(1, displacement),
                        .velocity = Vector::Zero(1)}};
  }
};

// Counts the impacts of the recorded window.
class Impacts : public motion::Observer {
public:
  void event(const motion::ContactEvent &event) override { count += event.onset ? 1 : 0; }
  long count = 0;
};

struct Found {
  PointResult result;
  long impacts = 0;
  const std::vector<double> &spectrum() const { return field(result, "lyapunov/spectrum").values; }
};

// All exponents over `cycles` intervals of the given period after `settling` of them.
Found exponents(const Oscillator &oscillator, double discarded, double period, long settling,
                long cycles) {
  const System system = oscillator.system();
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  trajectory.advance(static_cast<double>(settling) * period);
  LyapunovRecorder recorder({.exponents = 0, .discarded_share = discarded, .tolerance = 1e-11});
  Impacts impacts;
  motion::Observers all({&recorder, &impacts});
  recorder.begin(periods_window(trajectory.time(), period, cycles), trajectory);
  for (long cycle = 1; cycle <= cycles; ++cycle) {
    trajectory.advance(static_cast<double>(settling + cycle) * period, all);
    recorder.period_end(cycle, trajectory);
  }
  Found found{.result = {}, .impacts = impacts.count};
  recorder.add_fields(found.result);
  return found;
}

// Once per turn every deviation of the damped oscillator has shrunk by exp(-zeta T), however long
// the period.
TEST(LyapunovSpectrumTest, OfTheDampedOscillator) {
  const Oscillator free{.zeta = 0.08, .displacement = 1, .stiffness = 25};
  const Found found = exponents(free, 0, 2 * pi / std::sqrt(25 - 0.08 * 0.08), 0, 10);
  ASSERT_EQ(found.spectrum().size(), 2u);
  for (const double exponent : found.spectrum())
    EXPECT_NEAR(exponent, -0.08, 1e-12);
  EXPECT_NEAR(value(found.result, "lyapunov/mean_divergence"), -0.16, 1e-13);
  EXPECT_EQ(value(found.result, "lyapunov/kaplan_yorke_dimension"), 0);
}

// Overdamped there are two real roots, and a bumper that is never touched relaxes by itself at
// stiffness over damping constant.
TEST(LyapunovSpectrumTest, OfRealRoots) {
  const Oscillator free{.zeta = 1.5,
                        .stop = std::make_shared<KelvinVoigtBumper>(0.9, 1),
                        .clearance = 50,
                        .displacement = 1};
  const Found found = exponents(free, 0.5, 1, 0, 40);
  ASSERT_EQ(found.spectrum().size(), 3u);
  EXPECT_NEAR(found.spectrum()[0], -1.5 + std::sqrt(1.25), 1e-8);
  EXPECT_NEAR(found.spectrum()[1], -0.9, 1e-8);
  EXPECT_NEAR(found.spectrum()[2], -1.5 - std::sqrt(1.25), 1e-8);
}

// Each rigid impact takes the area of deviations times e^2, whatever the motion: chaotic here.
TEST(LyapunovSpectrumTest, SumOfARigidImpactOscillator) {
  const Oscillator impacting{.zeta = 0.02,
                             .amplitude = 1,
                             .omega = 2.8,
                             .stop = std::make_shared<NewtonRestitution>(0.8),
                             .clearance = 0};
  const long cycles = 400;
  const Found found = exponents(impacting, 0, impacting.period(), 200, cycles);
  ASSERT_EQ(found.spectrum().size(), 2u);
  const double duration = static_cast<double>(cycles) * impacting.period();
  EXPECT_GT(found.impacts, 100);
  const double expected =
      -2 * 0.02 + static_cast<double>(found.impacts) * 2 * std::log(0.8) / duration;
  EXPECT_NEAR(value(found.result, "lyapunov/mean_divergence"), expected, 1e-9);
  EXPECT_NEAR(found.spectrum()[0] + found.spectrum()[1], expected, 1e-9);
  EXPECT_GE(found.spectrum()[0], found.spectrum()[1]);
}

// On a periodic motion the exponents are the logarithms of the multipliers over the period, whose
// product is known: no area is lost at a spring.
TEST(LyapunovSpectrumTest, OfAPeriodicMotion) {
  const Oscillator impacting{.zeta = 0.1,
                             .amplitude = 1,
                             .omega = 1.65,
                             .stop = std::make_shared<LinearPenalty>(30),
                             .clearance = 0.3};
  const Found found = exponents(impacting, 0.5, impacting.period(), 200, 400);
  ASSERT_EQ(found.spectrum().size(), 2u);
  EXPECT_GT(found.spectrum()[0], -0.09); // real multipliers
  EXPECT_NEAR(found.spectrum()[0] + found.spectrum()[1], -0.2, 1e-10);
}

// In contact the bumper follows the mass: its own deviation ends when it is touched.
TEST(LyapunovSpectrumTest, OfABumperThatIsTouched) {
  const Oscillator impacting{.zeta = 0.1,
                             .amplitude = 1,
                             .omega = 1.2,
                             .stop = std::make_shared<KelvinVoigtBumper>(1, 1),
                             .clearance = 0.3};
  const Found found = exponents(impacting, 0, impacting.period(), 20, 20);
  ASSERT_EQ(found.spectrum().size(), 3u);
  EXPECT_LT(found.spectrum()[0], 0);
  EXPECT_TRUE(std::isfinite(found.spectrum()[1]));
  EXPECT_EQ(found.spectrum()[2], -std::numeric_limits<double>::infinity());
}

} // namespace lyapunov_spectrum_tests
} // namespace vibroimpact::analyses
