// Sliding and sticking under constant normal forces, against closed forms and published cases.
#include "model/time_function.h"
#include "support/friction_by_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::motion {
namespace friction_tests {

using namespace model;
using contact::ContactSet;
using testing::Changes;
using testing::coulomb;
using testing::single_mass;
using testing::sliding_along_x;
using testing::vector_of;
constexpr double pi = std::numbers::pi;

class FrictionTest : public testing::FrictionByMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, FrictionTest, ::testing::Values("exact", "rk"));

// Half a cycle loses 2 mu N / k; the mass rests where the spring pulls less than friction.
TEST_P(FrictionTest, AmplitudeOfAFreeMassFallsByTheSameAmount) {
  const Model model({single_mass("block", 1, 1e4, 0)});
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(10, 0.1, 0.1))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({8.5e-4}), vector_of({0}));
  trajectory.advance(0.3, changes);
  const double turns[] = {-6.5e-4, 4.5e-4, -2.5e-4, 5e-5};
  ASSERT_EQ(changes.list.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(changes.list[i].time, static_cast<double>(i + 1) * pi / 100, error(1e-13));
    EXPECT_NEAR(changes.list[i].state[0], turns[i], error(1e-12) * 8.5e-4);
  }
  EXPECT_EQ(changes.list.back().to, "stick");
  EXPECT_NEAR(trajectory.state()[0], 5e-5, error(1e-12) * 8.5e-4);
  EXPECT_EQ(trajectory.state()[1], 0);
  const StateLayout &layout = trajectory.layout();
  EXPECT_NEAR(trajectory.state()[layout.friction_work(0)], 0.5e4 * (8.5e-4 * 8.5e-4 - 5e-5 * 5e-5),
              error(1e-12) * 3.6e-3);
  EXPECT_NEAR(trajectory.state()[layout.sliding_way(0)], 1.5e-3 + 1.1e-3 + 7e-4 + 3e-4,
              error(1e-12) * 3.6e-3);
  EXPECT_NEAR(trajectory.state()[layout.wear_work(0)], 10 * 3.6e-3, error(1e-12) * 0.036);
  EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
}

// x'' + x = -sgn(x'), another program's example.
TEST_P(FrictionTest, FreeMassAtAnyInstant) {
  const Model model({single_mass("block", 1, 1, 0)});
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(1, 1, 1))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({12}), vector_of({6}));
  const double known[][2] = {{.49, 13.29739844},   {.99, 11.4520608},    {2.49, -4.762232256},
                             {4.99, -2.590794312}, {9.99, -7.262180916}, {14.74, .2676911293}};
  for (const auto &[time, x] : known) {
    trajectory.advance(time, changes);
    EXPECT_NEAR(trajectory.state()[0], x, 6e-9 + error(0)) << time;
  }
  trajectory.advance(30, changes);
  ASSERT_EQ(changes.list.size(), 8u);
  EXPECT_NEAR(changes.list.back().time, 22.42355635, 6e-9 + error(0));
  EXPECT_NEAR(trajectory.state()[0], .6821789367, 6e-11 + error(0));
}

// Two masses; the second one sticks 54 times until 500 s. Values by Taylor series of order 28 in
// thirty digits, each contact change located by Newton's method.
TEST_P(FrictionTest, DrivenMassOnOneThatSticks) {
  Model model({single_mass("driven", 1, 1, 0), single_mass("block", 1, 0, 0)});
  model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 1, 0.3, pi / 2),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  RowVector row(2);
  row << -1, 1;
  model.add_connection({.name = "spring",
                        .side_a = "driven.head",
                        .side_b = "block.head",
                        .elongation = {.row = row, .base_coefficients = {0}},
                        .stiffness = 1});
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(1, 0.5, 0.5))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({1, 0}), vector_of({0, 0}));
  const double known[][5] = {
      {1, .59204848951841, -.6477686267094, .19268426501681, .28062718246006},
      {5, .40770916266428, -.71801061879227, .31536544976625, 0},
      {10, -.7458607414838, -.4852545250432, -.028706474092093, -.045892687260031},
      {50, -.076515349226864, -.27953120808982, .44222904109053, -.00063805963354211},
      {100, -.18415570137684, -.15195218704748, -.36008914860786, 0},
      {500, .23625385454945, .37761405335171, -.25897233662266, 0},
  };
  for (const auto &[time, x1, v1, x2, v2] : known) {
    trajectory.advance(time, changes);
    const Vector &x = trajectory.state();
    for (const auto &[value, expected] : {std::pair(x[0], x1), {x[2], v1}, {x[1], x2}, {x[3], v2}})
      EXPECT_NEAR(value, expected, error(1e-12)) << time;
  }
  long stops = 0;
  for (const Changes::Change &change : changes.list)
    stops += change.to == "stick" ? 1 : 0;
  EXPECT_EQ(stops, 54);
  EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
}

// One mass sticks to the ground, another hangs on it, a third is free, on a base that shakes: with
// coordinates that nothing holds in place, of which rounding may leave 1e-16, all of them are
// driven.
TEST_P(FrictionTest, MassesBesideOneThatSticksOnAShakenBase) {
  const double m = 0.442005662916987, k = 10.8750664403451, c = 0.0026428326692376;
  const double a = 0.865, w = 24.60185992825, x0 = 0.01, v0 = 0.3;
  Model model({single_mass("free", 0.497057101855402, 0, 0), single_mass("hung", m, 0, 0),
               single_mass("block", 1.6723574318407, 1.34191891862169, 0.016030677731869)});
  model.add_base_motion("base", std::make_shared<Harmonic>(Given::acceleration, a, w, pi / 2),
                        {0, 1, 2}, Vector3::UnitX());
  RowVector row(3);
  row << 0, -1, 1;
  model.add_connection({.name = "spring",
                        .side_a = "hung.head",
                        .side_b = "block.head",
                        .elongation = {.row = row, .base_coefficients = {0}},
                        .stiffness = k,
                        .damping = c});
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(1e3, 0.7, 0.7))});
  Trajectory trajectory(model, contacts, settings());
  trajectory.start(0, vector_of({0, x0, 0}), vector_of({v0, v0, 0}));
  const double end = 3;
  Changes changes(contacts);
  trajectory.advance(end, changes);
  const double base = a / (w * w) * (1 - std::cos(w * end)); // its way
  const double d = c / m / 2, own = std::sqrt(k / m - d * d);
  const double hung =
      std::exp(-d * end) * (x0 * std::cos(own * end) + (v0 + d * x0) / own * std::sin(own * end));
  EXPECT_NEAR(trajectory.state()[0], v0 * end - base, error(1e-13));
  EXPECT_NEAR(trajectory.state()[1], hung - base, error(1e-13));
  EXPECT_NEAR(trajectory.state()[2], -base, error(1e-13));
  EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
}

// A chain of two masses breaks away, slips and sticks again; mu_s > mu.
TEST_P(FrictionTest, BreaksAwayAndSticksAgain) {
  Model model({single_mass("block", 5, 0, 0), single_mass("driven", 5, 0, 0)});
  model.add_force("force", make_constant(Given::displacement, 3000), {.body = 1, .point = 0},
                  Vector3::UnitX());
  RowVector row(2);
  row << -1, 1;
  const auto chain = [&](Model &of) {
    of.add_connection({.name = "spring",
                       .side_a = "block.head",
                       .side_b = "driven.head",
                       .elongation = {.row = row, .base_coefficients = {0}},
                       .stiffness = 1e4});
  };
  chain(model);
  const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(1e4, 0.2, 0.3))});
  Trajectory trajectory(model, contacts, settings());
  Changes changes(contacts);
  trajectory.start(0, vector_of({0, 0}), vector_of({0, 0}));
  trajectory.advance(.02, changes);
  EXPECT_NEAR(trajectory.state()[1], .1122103126, 6e-11 + error(0));
  trajectory.advance(.15, changes);
  ASSERT_EQ(changes.list.size(), 1u);
  EXPECT_NEAR(changes.list[0].time, std::acos(1 - 3000.0 / 3000) / std::sqrt(2000),
              1e-13 + error(0));
  const Vector x = trajectory.state();
  const double at[] = {1.35333766089, 1.80753246618, 15.786547411, 20.6050457229};
  for (Index i = 0; i < 4; ++i)
    EXPECT_NEAR(x[i], at[i], 6e-10 + error(0));
  trajectory.advance(.2, changes);
  EXPECT_NEAR(trajectory.state()[0], 2.59308836276, 6e-11 + error(0));
  EXPECT_NEAR(trajectory.state()[3], 20.9206206534, 6e-9 + error(0));

  Model unloaded({single_mass("block", 5, 0, 0), single_mass("driven", 5, 0, 0)});
  unloaded.add_force("force", make_constant(Given::displacement, 0), {.body = 1, .point = 0},
                     Vector3::UnitX());
  chain(unloaded);
  Trajectory rest(unloaded, contacts, settings());
  const Vector begin = trajectory.state();
  rest.start(.2, begin.head(2), begin.segment(2, 2));
  rest.advance(.339965, changes);
  ASSERT_EQ(changes.list.size(), 2u);
  EXPECT_NEAR(changes.list[1].time, .314923275447, 1e-12 + error(0));
  EXPECT_NEAR(changes.list[1].state[0], 3.9556057735, 6e-10 + error(0));
  EXPECT_NEAR(changes.list[1].state[1], 3.96484599853, 6e-11 + error(0));
  EXPECT_NEAR(changes.list[1].state[3], .422282954963, 6e-12 + error(0));
  EXPECT_NEAR(rest.state()[1], 3.968131227, 6e-10 + error(0));
}

// Den Hartog 1930: the amplitude without stops; with stops, by simulation elsewhere.
TEST_P(FrictionTest, ForcedAmplitudes) {
  const auto closed_form = [](double b, double f) {
    const double v = 1 / (1 - b * b);
    const double u = std::sin(pi / b) / (b * (1 + std::cos(pi / b)));
    return std::sqrt(v * v - u * u * f * f);
  };
  const double cases[][3] = {{.6, .2, closed_form(.6, .2)},
                             {.6, .4, closed_form(.6, .4)},
                             {.8, .4, closed_form(.8, .4)},
                             {.8, .6, closed_form(.8, .6)},
                             {1.2, .2, closed_form(1.2, .2)},
                             {1.2, .4, closed_form(1.2, .4)},
                             {1.2, .6, closed_form(1.2, .6)},
                             {1.5, .4, closed_form(1.5, .4)},
                             {1.5, .6, .4},
                             {2, .4, .2666666666666667},
                             {.6, .6, 1.4432241317},
                             {2, .6, .1453942681}};
  for (const auto &[b, f, amplitude] : cases) {
    Model model({single_mass("block", 1, 1, 0)});
    model.add_force("force", std::make_shared<Harmonic>(Given::displacement, 1, b, pi / 2),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(f, 1, 1))});
    Trajectory trajectory(model, contacts, settings());
    trajectory.start(0, vector_of({amplitude}), vector_of({0}));
    const double period = 2 * pi / b;
    // What is left of a deviation after a period without stops.
    const double kept = (amplitude * b * b - f) / (amplitude * b * b + f);
    const double periods = kept > 0 ? std::ceil(std::log(1e-14) / std::log(kept)) : 20;
    trajectory.advance(periods * period);
    Changes changes(contacts);
    trajectory.advance((periods + 1) * period, changes);
    double largest = 0;
    for (const Changes::Change &change : changes.list)
      largest = std::max(largest, std::abs(change.state[0]));
    const bool stops = changes.list.size() != 2;
    EXPECT_NEAR(largest, amplitude, stops ? 6e-11 + error(0) : error(1e-12)) << b << ' ' << f;
    EXPECT_EQ(stops, f == .6 && (b == .6 || b == 2)) << b << ' ' << f;
  }
}

// mu_s > mu: the block sticks on the belt and slips back.
TEST_P(FrictionTest, StickSlipOnABelt) {
  const double cases[][5] = {{1, 1, 1, .5, .2}, {1, 10, .4, .25, .5}};
  for (const auto &[k, n, mu_s, mu, vb] : cases) {
    const Model model({single_mass("block", 1, k, 0)});
    const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(n, mu, mu_s), vb)});
    Trajectory trajectory(model, contacts, settings());
    Changes changes(contacts);
    trajectory.start(0, vector_of({0}), vector_of({vb}));
    trajectory.advance(60, changes);
    const double drop = (mu_s - mu) * n / k;
    const double stick = 2 * drop / vb;
    const double slip = 2 / std::sqrt(k) * (pi - std::atan(drop * std::sqrt(k) / vb));
    ASSERT_GT(changes.list.size(), 6u);
    for (std::size_t i = 0; i + 2 < changes.list.size(); ++i) {
      const bool sticks = changes.list[i].to == "stick";
      EXPECT_NEAR(changes.list[i + 1].time - changes.list[i].time, sticks ? stick : slip,
                  error(1e-12));
      if (!sticks) {
        EXPECT_NEAR(changes.list[i].state[0], mu_s * n / k, error(1e-12));
      }
    }
    EXPECT_LT(trajectory.accuracy().energy_residual, error(1e-12));
  }
}

// The wear power of a block on a shaken table, as published: from 4 s to 12 s.
TEST_P(FrictionTest, WearOfAShakenBlock) {
  const double cases[][2] = {
      {15, 15.26709959}, {1.5, .4090624510}, {1.01, 2.261641213e-4}, {.99, 0}};
  for (const auto &[amplitude, power] : cases) {
    Model model({single_mass("block", 1, 0, 0)});
    model.add_force("table", std::make_shared<Harmonic>(Given::displacement, amplitude, 2 * pi, 0),
                    {.body = 0, .point = 0}, Vector3::UnitX());
    const ContactSet contacts({sliding_along_x(model, "block.head", "", coulomb(10, 0.1, 0.1))});
    Trajectory trajectory(model, contacts, settings());
    Changes changes(contacts);
    trajectory.start(0, vector_of({0}), vector_of({0}));
    trajectory.advance(4, changes);
    const Index wear = trajectory.layout().wear_work(0);
    const double before = trajectory.state()[wear];
    trajectory.advance(12, changes);
    EXPECT_NEAR((trajectory.state()[wear] - before) / 8, power, 6e-10 * power + error(0))
        << amplitude;
    EXPECT_NEAR(trajectory.state()[trajectory.layout().friction_work(0)],
                0.1 * trajectory.state()[wear], error(1e-12) * trajectory.state()[wear]);
  }
}

} // namespace friction_tests
} // namespace vibroimpact::motion
