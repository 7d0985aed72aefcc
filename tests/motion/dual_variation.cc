// The variation of motions, by state and by keys, against a second program in dual numbers that
// forms neither Jacobians nor saltations: two masses on a moving base, one of which meets a stop,
// for each law, linear and with a cubic spring between them.
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/tsuji.h"
#include "motion/variation/linearised_motion.h"
#include "support/dual_laws.h"
#include "support/key_families.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vibroimpact::motion {
namespace dual_variation_tests {

using namespace contact;
using namespace model;
using testing::Dual;
using testing::Duals;
using testing::Parts;

// Keys by their places.
enum : std::size_t { mass, link, cubic, stiffness, loss, clearance, amplitude, frequency, n_keys };

template <typename Number> using Values = std::array<Number, n_keys>;

struct Law {
  std::string name;
  double stiffness, loss;
  bool internal = false;
  double force = 0; ///< on the first mass [N]
};

std::shared_ptr<const ContactLaw> make_law(const std::string &name, double k, double c) {
  if (name == "linear penalty")
    return std::make_shared<LinearPenalty>(k);
  if (name == "kelvin-voigt")
    return std::make_shared<KelvinVoigt>(k, c);
  if (name == "bilinear stop")
    return std::make_shared<BilinearStop>(k, c);
  if (name == "kelvin-voigt bumper")
    return std::make_shared<KelvinVoigtBumper>(k, c);
  if (name == "hertz")
    return std::make_shared<Hertz>(HertzConstants{.stiffness = k});
  if (name == "hunt-crossley")
    return HuntCrossley::with_dissipation({.stiffness = k}, c);
  if (name == "hunt-crossley of the approach speed")
    return HuntCrossley::with_dimensionless_damping({.stiffness = k}, c, 1e-9);
  if (name == "tsuji")
    return std::make_shared<Tsuji>(k, c);
  if (name == "kuwabara-kono")
    return std::make_shared<KuwabaraKono>(k, c);
  return testing::newton(c);
}

constexpr double start_time = 0.2;

Parts make_parts(const Law &law, const Values<double> &values) {
  Parts parts{.model = Model({testing::single_mass("a", values[mass], 40, 0.5),
                              testing::single_mass("b", 2, 10, 0.1)}),
              .contacts = {}};
  parts.model.add_base_motion(
      "shake",
      std::make_shared<Harmonic>(Given::displacement, values[amplitude], values[frequency], 0.3),
      {0, 1}, Vector3::UnitX());
  parts.model.add_force("weight", make_constant(Given::displacement, law.force),
                        {.body = 0, .point = 0}, Vector3::UnitX());
  Projection elongation =
      parts.model.displacement({.body = 1, .point = 0}, Vector3::UnitX(), false);
  elongation.row[0] = -1;
  parts.model.add_connection({.name = "link",
                              .side_a = "a.head",
                              .side_b = "b.head",
                              .elongation = elongation,
                              .stiffness = values[link],
                              .cubic_stiffness = values[cubic],
                              .damping = 0.3});
  parts.contacts =
      ContactSet({testing::contact_along_x(parts.model, "a.head", "", values[clearance],
                                           make_law(law.name, values[stiffness], values[loss]))});
  return parts;
}

testing::DualSystem make_dual(const Law &law, const Values<Dual> &values) {
  const Dual k = values[link], c = 0.3;
  const testing::DualLaw constants{.stiffness = values[stiffness], .loss = values[loss]};
  testing::DualSystem system{
      .mass = {values[mass], 2},
      .stiffness = {{Dual(40) + k, -k}, {-k, Dual(10) + k}},
      .damping = {{Dual(0.5) + c, -c}, {-c, Dual(0.1) + c}},
      .base = {.amplitude = values[amplitude], .frequency = values[frequency], .phase = 0.3},
      .constant_force = {law.force, 0},
      .cubic_stiffness = values[cubic]};
  system.contacts.push_back({.row = {-1, 0},
                             .clearance = values[clearance],
                             .by_base = -1,
                             .modes = testing::dual_modes(law.name, constants),
                             .restitution = values[loss]});
  return system;
}

struct Outcome {
  Matrix derivatives; ///< by the state, then by keys
  Vector state;
  int events = 0;
};

class DualVariationTest : public ::testing::TestWithParam<std::tuple<Law, double>> {
protected:
  Law law() const { return std::get<0>(GetParam()); }
  Values<double> values() const {
    return {1, 20, std::get<1>(GetParam()), law().stiffness, law().loss, 0.03, 0.05, 7};
  }
  // A law without loss has no such key; none is negative.
  std::vector<std::size_t> keys() const {
    std::vector<std::size_t> list = {mass, link, cubic, stiffness, clearance, amplitude, frequency};
    if (law().loss > 0)
      list.push_back(loss);
    return list;
  }
  Index n_states() const { return law().internal ? 5 : 4; }
  Vector start() const {
    Vector state(n_states());
    state.head(4) << -0.1, 0.05, 0.3, -0.2;
    if (law().internal)
      state[4] = make_law(law().name, law().stiffness, law().loss)->initial_internal()[0];
    return state;
  }

  Outcome by_dual_numbers(double end, double refinement) const {
    std::size_t place = 0;
    Duals state;
    for (const double number : start())
      state.push_back(Dual::variable(number, place++));
    Values<Dual> numbers;
    for (std::size_t k = 0; k < n_keys; ++k)
      numbers[k] = values()[k];
    for (const std::size_t key : keys())
      numbers[key] = Dual::variable(values()[key], place++);
    testing::DualSystem system = make_dual(law(), numbers);
    if (law().internal)
      system.contacts[0].internal = state[4];
    testing::DualMotion motion(system, {state[0], state[1]}, {state[2], state[3]}, start_time,
                               0.015, 1e-3, refinement);
    motion.advance(end);
    const Duals after =
        motion.state(law().internal ? std::vector<std::size_t>{0} : std::vector<std::size_t>{});
    Outcome outcome{.derivatives = Matrix(n_states(), static_cast<Index>(place)),
                    .state = Vector(n_states()),
                    .events = motion.events()};
    for (Index i = 0; i < n_states(); ++i) {
      const Dual &entry = after[static_cast<std::size_t>(i)];
      outcome.state[i] = entry.value;
      for (Index j = 0; j < outcome.derivatives.cols(); ++j)
        outcome.derivatives(i, j) = entry.by[static_cast<std::size_t>(j)];
    }
    return outcome;
  }

  Outcome by_variation(double end) const {
    const Parts parts = make_parts(law(), values());
    std::vector<std::unique_ptr<KeyTangent>> tangents;
    std::vector<KeyTangent *> list;
    for (const std::size_t key : keys()) {
      tangents.push_back(tangent(parts, key));
      list.push_back(tangents.back().get());
    }
    Trajectory trajectory(parts.model, parts.contacts,
                          {.relative_tolerance = 1e-13, .event_tolerance = 1e-15});
    Lineariser linearise(trajectory, {.scale = Vector::Ones(n_states()), .tolerance = 1e-13});
    const LinearisedMotion motion = linearise({.time = start_time, .physical = start()}, end, list);
    Outcome outcome{.derivatives =
                        Matrix(n_states(), n_states() + static_cast<Index>(keys().size())),
                    .state = motion.end.physical,
                    .events = static_cast<int>(motion.events)};
    outcome.derivatives << motion.by_state, motion.by_key;
    EXPECT_EQ(motion.without_derivative, 0);
    return outcome;
  }

private:
  std::unique_ptr<KeyTangent> tangent(const Parts &parts, std::size_t key) const {
    std::vector<KeyNeighbour> neighbours;
    for (const double place : {-2e-3, -1e-3, 1e-3, 2e-3}) {
      Values<double> near = values();
      const double offset = place * (near[key] == 0 ? 1 : near[key]);
      near[key] += offset;
      Parts parts_near = make_parts(law(), near);
      neighbours.push_back(
          KeyNeighbour::of(offset, std::move(parts_near.model), std::move(parts_near.contacts)));
    }
    return std::make_unique<KeyTangent>("key", parts.model, parts.contacts, std::move(neighbours));
  }
};

// Largest entry of each column by which two differ, relative to the column. One that has died out,
// as a deviation of a stop that has recovered, is no more than the error of the steps.
double apart(const Matrix &own, const Matrix &other) {
  double largest = 0;
  for (Index j = 0; j < own.cols(); ++j) {
    const double size = other.col(j).cwiseAbs().maxCoeff();
    if (size > 1e-6 * other.cwiseAbs().maxCoeff())
      largest = std::max(largest, (own.col(j) - other.col(j)).cwiseAbs().maxCoeff() / size);
  }
  return largest;
}

TEST_P(DualVariationTest, DerivativesByStateAndKeys) {
  const double end = 2.4;
  const Outcome dual = by_dual_numbers(end, 2);
  const Outcome coarse = by_dual_numbers(end, 1);
  const Outcome own = by_variation(end);
  EXPECT_GE(dual.events, 3);
  EXPECT_EQ(dual.events, own.events);
  EXPECT_LT(apart(coarse.derivatives, dual.derivatives), 1e-8); // that of `dual` is far below
  EXPECT_LT((dual.state - own.state).norm(), 1e-10);
  EXPECT_LT(apart(own.derivatives, dual.derivatives), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Laws, DualVariationTest,
    ::testing::Combine(::testing::Values(Law{"linear penalty", 2000, 0},
                                         Law{"kelvin-voigt", 2000, 8},
                                         Law{"bilinear stop", 500, 12},
                                         Law{"kelvin-voigt bumper", 2000, 15, true},
                                         Law{"hertz", 2e4, 0}, Law{"hunt-crossley", 2e4, 0.5},
                                         Law{"hunt-crossley of the approach speed", 2e4, 0.4, true},
                                         Law{"tsuji", 2e4, 20}, Law{"kuwabara-kono", 2e4, 2e-3},
                                         Law{"newton restitution", 1, 0.7},
                                         Law{"newton restitution", 1, 0, false, 4}),
                       ::testing::Values(0.0, 300.0)));

} // namespace dual_variation_tests
} // namespace vibroimpact::motion
