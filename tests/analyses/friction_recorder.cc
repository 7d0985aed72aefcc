// Work of friction along the circumference of circular gaps, and standard errors of work rates:
// closed forms, plane contacts, other divisions of the circumference.
#include "analyses/recorders/friction.h"
#include "contact/friction/spring_slider.h"
#include "contact/laws/kelvin_voigt.h"
#include "support/circular_contacts.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace friction_recorder_tests {

using contact::Coulomb;
using contact::LinearPenalty;
using model::Given;
using model::Harmonic;
using model::Model;
using testing::field_of;
using testing::recorded;
using testing::value_of;
constexpr double pi = std::numbers::pi;
const std::string friction = "contact/ring/friction/";

const std::vector<double> &sectors(const PointResult &result, const std::string &name) {
  return field_of(result, friction + "sector/" + name).values;
}

double sum(const std::vector<double> &values) {
  double all = 0;
  for (const double value : values)
    all += value;
  return all;
}

void expect_whole(const PointResult &result) {
  const double rate = value_of(result, friction + "work_rate");
  const double energy = value_of(result, friction + "energy");
  EXPECT_NEAR(sum(sectors(result, "work_rate")), rate, 1e-14 * rate);
  EXPECT_NEAR(sum(sectors(result, "energy")), energy, 1e-14 * energy);
}

/// An unbalance m e W^2 that presses the rotor on a ring of stiffness .5, m = k = 1: an orbit of
/// the radius r, [(1 - W^2) r + N]^2 + [c W r + mu N]^2 = (e W^2)^2 with N = .5 (r - .1).
struct Rub {
  double speed = 1.1, radius = .312100708201, damping = 0.1, mu = 0.1;
  double force() const { return 0.5 * (radius - 0.1); }
  double period() const { return 2 * pi / speed; }
  System system() const {
    Model model({testing::isotropic("rotor", 1, 1, damping)});
    const double load = 0.05 * speed * speed;
    model.add_force("along", std::make_shared<Harmonic>(Given::displacement, load, speed, pi / 2),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    model.add_force("across", std::make_shared<Harmonic>(Given::displacement, load, speed, 0),
                    {.body = 0, .point = 0}, Vector3::UnitY());
    contact::ContactSet contacts(
        {testing::ring_about_z(model, "rotor.head", "", 0.1, std::make_shared<LinearPenalty>(0.5),
                               std::make_shared<Coulomb>(mu, mu))});
    System system = testing::system_of(std::move(model), std::move(contacts));
    const std::complex<double> balance((1 - speed * speed) * radius + force(),
                                       damping * speed * radius + mu * force());
    const std::complex<double> start = std::polar(radius, -std::arg(balance));
    const std::complex<double> velocity = std::complex<double>(0, speed) * start;
    system.initial.displacement << start.real(), start.imag();
    system.initial.velocity << velocity.real(), velocity.imag();
    return system;
  }
};

TEST(FrictionRecorder, ASynchronousRubIsUniform) {
  const Rub rub;
  const double rate = rub.force() * rub.speed * rub.radius;
  for (const long n : {1, 2, 7, 36}) {
    const PointResult result = recorded<FrictionRecorder>(
        rub.system(), periods_window(0, rub.period(), 3), FrictionSettings{.sectors = n});
    EXPECT_NEAR(value_of(result, friction + "work_rate"), rate, 1e-9 * rate);
    ASSERT_EQ(sectors(result, "work_rate").size(), static_cast<std::size_t>(n));
    for (long k = 0; k < n; ++k) {
      EXPECT_NEAR(sectors(result, "work_rate")[static_cast<std::size_t>(k)],
                  rate / static_cast<double>(n), 1e-9 * rate)
          << k << " of " << n;
      EXPECT_NEAR(sectors(result, "energy")[static_cast<std::size_t>(k)],
                  3 * rub.period() * rub.mu * rate / static_cast<double>(n), 1e-8 * rate);
    }
    expect_whole(result);
    for (const double error : sectors(result, "work_rate_error"))
      EXPECT_LT(error, 1e-9 * rate);
  }
}

// From t = 0 on, over an angle that ends within a sector: every sector has what the angle swept
// there says.
TEST(FrictionRecorder, APartOfATurnEndsWithinASector) {
  const Rub rub;
  const System system = rub.system();
  const double first = std::atan2(system.initial.displacement[1], system.initial.displacement[0]);
  const long n = 8;
  const double width = 2 * pi / n, swept = 2.6 * width;
  const Window window{.start = 0, .end = swept / rub.speed};
  const PointResult result =
      recorded<FrictionRecorder>(system, window, FrictionSettings{.sectors = n});
  const double rate = rub.force() * rub.speed * rub.radius;
  for (long k = 0; k < n; ++k) {
    double covered = 0;
    for (const double turn : {-2 * pi, 0.0, 2 * pi}) {
      const double from = (static_cast<double>(k) - 0.5) * width + turn;
      covered += std::max(0.0, std::min(first + swept, from + width) - std::max(first, from));
    }
    EXPECT_NEAR(sectors(result, "work_rate")[static_cast<std::size_t>(k)], rate * covered / swept,
                1e-9 * rate)
        << k;
  }
  expect_whole(result);
}

// Along a diameter a ring wears where the diameter ends, by the impulses of plane stops there.
TEST(FrictionRecorder, AlongADiameterTwoSectorsWear) {
  const double speed = 3, clearance = 0.013;
  const auto law = std::make_shared<contact::KelvinVoigt>(3e4, 90);
  const auto belt = std::make_shared<Coulomb>(0.2, 0.2);
  const auto ball = [&](double load) {
    Model model({testing::single_mass("ball", 1.5, 400, 0.3)});
    model.add_force("push", model::make_constant(Given::displacement, load), {}, Vector3::UnitX());
    return model;
  };
  for (const double load : {0.0, 7.0}) {
    Model model = ball(load);
    contact::ContactPair right = testing::contact_along_x(model, "ball.head", "", clearance, law);
    contact::ContactPair left = right;
    left.gap.row *= -1;
    const contact::ContactSet both({right, left});
    motion::Trajectory stops(model, both, {.relative_tolerance = 1e-12});
    const double start = load > 0 ? 0.011 : 0.002, velocity = load > 0 ? 0 : 0.8;
    stops.start(0, Vector::Constant(1, start), Vector::Constant(1, velocity));
    testing::Changes with_integrals(both);
    stops.advance(0.4, with_integrals);
    const double impulses[] = {stops.state()[stops.layout().impulse(0)],
                               stops.state()[stops.layout().impulse(1)]};

    Model within = ball(load);
    contact::ContactSet ring(
        {testing::ring_about_z(within, "ball.head", "", clearance, law, belt, speed)});
    System system = testing::system_of(std::move(within), std::move(ring));
    system.integration.relative_tolerance = 1e-12;
    system.initial.displacement[0] = start;
    system.initial.velocity[0] = velocity;
    const PointResult result = recorded<FrictionRecorder>(system, Window{.start = 0, .end = 0.4},
                                                          FrictionSettings{.sectors = 12});
    const std::vector<double> &rates = sectors(result, "work_rate");
    const double total = speed * (impulses[0] + impulses[1]) / 0.4;
    EXPECT_GT(impulses[0], 0);
    EXPECT_EQ(impulses[1] > 0, load == 0);
    for (std::size_t k = 0; k < 12; ++k) {
      const double impulse = k == 0 ? impulses[0] : k == 6 ? impulses[1] : 0;
      EXPECT_NEAR(rates[k], speed * impulse / 0.4, 1e-10 * total) << k;
    }
    expect_whole(result);
    EXPECT_EQ(value_of(result, friction + "sector/largest_work_rate"),
              *std::max_element(rates.begin(), rates.end()));
    if (load > 0) {
      EXPECT_EQ(value_of(result, friction + "sector/largest_angle"), 0);
    }
  }
}

/// A ball that bounces in a ring whose surface moves, and slides along it by some degrees in each
/// contact.
System bouncing(double tolerance) {
  Model model({testing::isotropic("ball", 1.5, 40, 0.1)});
  contact::ContactSet ring(
      {testing::ring_about_z(model, "ball.head", "", 0.013, std::make_shared<LinearPenalty>(900),
                             std::make_shared<contact::SpringSlider>(700.0, 0.2, 0.5), 1)});
  System system = testing::system_of(std::move(model), std::move(ring));
  system.integration.relative_tolerance = tolerance;
  system.initial.displacement << 0.003, -0.004;
  system.initial.velocity << 0.3, 0.2;
  return system;
}

// Each bounce in a rigid ring takes mu p (v + v') / 2 at one place, p = m (1 + e) into the impulse
// along the normal, v and v' = v - mu (1 + e) into the speeds along the wall.
TEST(FrictionRecorder, BouncesInARigidRing) {
  const double e = 0.8, mu = 0.02, mass = 1.5, end = 12;
  Model model({testing::isotropic("ball", mass, 0, 0)});
  contact::ContactSet contacts({testing::ring_about_z(
      model, "ball.head", "", 1, std::make_shared<contact::NewtonRestitution>(e),
      std::make_shared<Coulomb>(mu, mu))});
  System system = testing::system_of(std::move(model), std::move(contacts));
  system.initial.displacement << 0.5, 0;
  system.initial.velocity << 0.6, 0.8;
  const PointResult result = recorded<FrictionRecorder>(system, Window{.start = 0, .end = end},
                                                        FrictionSettings{.sectors = 5});
  double along = 0.4, into = std::sqrt(0.84), time = into - 0.3;
  double angle = std::atan2(0.8 * time, 0.5 + 0.6 * time);
  std::vector<double> energy(5, 0.0);
  while (time < end) {
    const auto sector = static_cast<std::size_t>(std::lround(angle / (2 * pi / 5))) % 5;
    const double slower = along - mu * (1 + e) * into;
    energy[sector] += mu * mass * (1 + e) * into * (along + slower) / 2;
    along = slower;
    into *= e;
    time += 2 * into / (into * into + along * along);
    angle += 2 * std::atan2(into, along);
  }
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(sectors(result, "energy")[k], energy[k], 1e-12 * sum(energy)) << k;
  expect_whole(result);
}

// Nine sectors are three times three; the errors follow the tolerance.
TEST(FrictionRecorder, SectorsOfSectors) {
  const auto rates = [](double tolerance, long n) {
    return sectors(recorded<FrictionRecorder>(bouncing(tolerance), Window{.start = 0, .end = 6},
                                              FrictionSettings{.sectors = n}),
                   "work_rate");
  };
  const std::vector<double> best = rates(1e-13, 9);
  const double total = sum(best);
  for (const double tolerance : {1e-8, 1e-11}) {
    const std::vector<double> nine = rates(tolerance, 9), three = rates(tolerance, 3);
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_GT(nine[k], 1e-3 * total);
      EXPECT_NEAR(nine[k], best[k], 100 * tolerance * total) << k;
    }
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(nine[3 * k] + nine[3 * k + 1] + nine[(3 * k + 8) % 9], three[k], 1e-13 * total);
  }
}

// r = 2, 5, 5 over durations of 1, 2, 1: mean 17/4.
TEST(FrictionRecorder, StandardErrorOfUnequalBlocks) {
  BlockMeans means;
  const auto at = [](double total) { return Vector::Constant(1, total); };
  means.begin(10, at(100));
  means.end_block(11, at(102));
  EXPECT_TRUE(std::isnan(means.standard_errors()[0]));
  means.end_block(13, at(112));
  means.end_block(14, at(117));
  const double squares = (2.25 * 2.25 + 1.5 * 1.5 + 0.75 * 0.75) / 16;
  EXPECT_NEAR(means.standard_errors()[0], std::sqrt(1.5 * squares), 1e-15);
}

// Where the work of each period is known, so are the errors: blocks are of whole periods.
TEST(FrictionRecorder, BlocksAreWholePeriods) {
  const Rub rub;
  const double rate = rub.force() * rub.speed * rub.radius;
  for (const long cycles : {1, 2, 7, 25}) {
    const PointResult result = recorded<FrictionRecorder>(
        rub.system(), periods_window(0, rub.period(), cycles), FrictionSettings{.sectors = 2});
    const double error = value_of(result, friction + "sector/largest_work_rate_error");
    EXPECT_TRUE(cycles == 1 ? std::isnan(error) : error < 1e-8 * rate) << cycles;
  }
  // Seven tenths of a turn in each block see both sectors unequally.
  const PointResult parts = recorded<FrictionRecorder>(
      rub.system(), Window{.start = 0, .end = 7 * rub.period()}, FrictionSettings{.sectors = 2});
  EXPECT_GT(value_of(parts, friction + "sector/largest_work_rate_error"), 1e-3 * rate);
}

} // namespace friction_recorder_tests
} // namespace vibroimpact::analyses
