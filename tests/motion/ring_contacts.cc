// Contacts in circular gaps that are solved as a whole, against a Runge-Kutta integration in
// extended precision and against steps.
#include "contact/friction/spring_slider.h"
#include "contact/friction/stribeck.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "support/circular_contacts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace vibroimpact::motion {
namespace ring_contacts_tests {

using namespace model;
using contact::CircularGap;
using contact::ContactSet;
using contact::Coulomb;
using contact::LinearPenalty;
using testing::ring_about_z;
using testing::settings_of;
constexpr double pi = std::numbers::pi;

/// A mass of 1 kg on springs along x and y, driven along both, and a fixed round side.
struct Setting {
  double springs[2] = {1, 1.1};
  double damping = 0.1;
  double amplitude = 1, forcing = 0.8;
  double stiffness = 60, exponent = 1, dissipation = 0;
  double friction = 0, surface = 0;
  CircularGap::Kind kind = CircularGap::Kind::inside;
  std::array<double, 2> centre{};
  double clearance = 1;

  double sense() const { return kind == CircularGap::Kind::inside ? 1 : -1; }
};

/// q, q', and the integrals of normal force, power of friction, and sliding speed.
using State = std::array<long double, 7>;

class Reference {
public:
  explicit Reference(const Setting &setting) : s_(setting) {}

  int contacts = 0;

  State run(State x, long double end) {
    constexpr long double step = 1e-4L;
    long double time = 0;
    bool inside = penetration(x) > 0;
    while (time < end) {
      const long double h = std::min(step, end - time);
      State next = moved(x, time, h, inside);
      if ((penetration(next) > 0) != inside) {
        const long double part = change(x, time, h, inside);
        x = moved(x, time, part, inside);
        time += part;
        inside = !inside;
        contacts += inside ? 1 : 0;
        continue;
      }
      x = next;
      time += h;
    }
    return x;
  }

private:
  long double distance(const State &x) const {
    return std::hypot(s_.centre[0] - x[0], s_.centre[1] - x[1]);
  }
  long double penetration(const State &x) const {
    return s_.sense() * (distance(x) - s_.clearance);
  }

  State slope(const State &x, long double time, bool inside) const {
    State d{x[2], x[3]};
    d[2] = s_.amplitude * std::cos(s_.forcing * time) - s_.springs[0] * x[0] - s_.damping * x[2];
    d[3] = s_.amplitude * std::sin(s_.forcing * time) - s_.springs[1] * x[1] - s_.damping * x[3];
    if (!inside)
      return d;
    const long double r = distance(x);
    const long double normal[] = {-s_.sense() * (s_.centre[0] - x[0]) / r,
                                  -s_.sense() * (s_.centre[1] - x[1]) / r};
    const long double tangent[] = {-normal[1], normal[0]};
    const long double gap_rate = -(normal[0] * x[2] + normal[1] * x[3]);
    const long double slip = -(tangent[0] * x[2] + tangent[1] * x[3]) + s_.surface;
    const long double push =
        s_.stiffness *
        std::pow(std::max(0.0L, penetration(x)), static_cast<long double>(s_.exponent)) *
        (1 - s_.dissipation * gap_rate);
    const long double drag = slip > 0 ? -s_.friction * push : s_.friction * push;
    for (std::size_t k = 0; k < 2; ++k)
      d[2 + k] -= push * normal[k] + drag * tangent[k];
    d[4] = push;
    d[5] = -drag * slip;
    d[6] = std::abs(slip);
    return d;
  }

  // The classical method.
  State moved(const State &x, long double time, long double h, bool inside) const {
    const auto at = [&](const State &k, long double part) {
      State y = x;
      for (std::size_t i = 0; i < y.size(); ++i)
        y[i] += part * k[i];
      return y;
    };
    const State a = slope(x, time, inside);
    const State b = slope(at(a, h / 2), time + h / 2, inside);
    const State c = slope(at(b, h / 2), time + h / 2, inside);
    const State d = slope(at(c, h), time + h, inside);
    State y = x;
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return y;
  }

  // Beyond the change by a little.
  long double change(const State &x, long double time, long double h, bool inside) const {
    long double low = 0, high = h;
    for (int i = 0; i < 70; ++i) {
      const long double middle = (low + high) / 2;
      ((penetration(moved(x, time, middle, inside)) > 0) == inside ? low : high) = middle;
    }
    return high;
  }

  Setting s_;
};

Model model_of(const Setting &setting) {
  auto body =
      std::make_shared<reduction::ReducedBody>(*testing::isotropic("ball", 1, 1, setting.damping));
  for (Index k = 0; k < 2; ++k)
    body->stiffness[k] = setting.springs[k];
  Model model({body});
  const auto drive = [&](const char *name, double size, double phase, const Vector3 &direction) {
    model.add_force(name,
                    std::make_shared<Harmonic>(Given::displacement, size, setting.forcing, phase),
                    {.body = 0, .point = 0}, direction);
  };
  drive("along", setting.amplitude, pi / 2, Vector3::UnitX());
  drive("across", setting.amplitude, 0, Vector3::UnitY());
  return model;
}

ContactSet contacts_of(const Setting &setting, const Model &model) {
  const contact::HertzConstants constants{.stiffness = setting.stiffness,
                                          .exponent = setting.exponent};
  std::shared_ptr<const contact::ContactLaw> normal;
  if (setting.exponent == 1)
    normal = std::make_shared<LinearPenalty>(setting.stiffness);
  else if (setting.dissipation == 0)
    normal = std::make_shared<contact::Hertz>(constants);
  else
    normal = contact::HuntCrossley::with_dissipation(constants, setting.dissipation);
  std::shared_ptr<const contact::TangentialLaw> friction;
  if (setting.friction > 0)
    friction = std::make_shared<Coulomb>(setting.friction, setting.friction);
  return ContactSet({ring_about_z(model, "ball.head", "", setting.clearance, normal, friction,
                                  setting.surface, setting.kind, setting.centre)});
}

const Setting frictionless{};
const Setting with_friction{.friction = 0.03};
// Of a force that begins like u^(3/2) not all digits are reached by any number of nodes.
const Setting hertz{.stiffness = 200, .exponent = 1.5};
const Setting hertz_with_friction{.stiffness = 200, .exponent = 1.5, .friction = 0.03};
const Setting hunt_crossley{
    .stiffness = 200, .exponent = 1.5, .dissipation = 0.1, .friction = 0.03};
const Setting moving_surface{.friction = 0.02, .surface = 3};
const Setting post{.amplitude = 0.4,
                   .friction = 0.03,
                   .kind = CircularGap::Kind::beside,
                   .centre = {1.4, 0},
                   .clearance = 0.5};

struct Outcome {
  Vector state;
  Accuracy accuracy;
  StateLayout layout;
};

Outcome motion(const Setting &setting, const State &start, double end, const std::string &method,
               double tolerance, Observer *observer = nullptr) {
  const Model model = model_of(setting);
  const ContactSet contacts = contacts_of(setting, model);
  Settings settings = settings_of(method);
  settings.relative_tolerance = tolerance;
  settings.absolute_tolerance = 0;
  Trajectory trajectory(model, contacts, settings);
  Vector at(4);
  for (Index i = 0; i < 4; ++i)
    at[i] = static_cast<double>(start[static_cast<std::size_t>(i)]);
  trajectory.start(0, at.head(2), at.tail(2));
  if (observer)
    trajectory.advance(end, *observer);
  else
    trajectory.advance(end);
  return {trajectory.state(), trajectory.accuracy(), trajectory.layout()};
}

constexpr State start = {0.7L, 0.1L, 0.3L, 0.9L};

double distance(const Vector &state, const State &exact) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    sum = std::max(sum, std::abs(state[static_cast<Index>(i)] - static_cast<double>(exact[i])));
  return sum;
}

class RingContacts : public ::testing::TestWithParam<Setting> {};

INSTANTIATE_TEST_SUITE_P(Laws, RingContacts,
                         ::testing::Values(frictionless, with_friction, hertz, hertz_with_friction,
                                           hunt_crossley, moving_surface, post));

/// Sees nothing but keeps the integrals.
struct Witness : Observer {
  bool sees_steps(const Equations & /*equations*/) const override { return false; }
};

TEST_P(RingContacts, FollowAnIntegrationInExtendedPrecision) {
  const double end = 24;
  Reference reference(GetParam());
  const State exact = reference.run(start, end);
  Witness witness;
  const double tolerance = GetParam().exponent == 1 ? 1e-12 : 1e-9;
  const double error = 10 * tolerance;
  const Outcome whole = motion(GetParam(), start, end, "exact", tolerance, &witness);
  ASSERT_GT(reference.contacts, 1);
  const auto interrupted = static_cast<std::size_t>(StepReason::interrupted); // by the end
  EXPECT_EQ(whole.accuracy.contact_episodes + whole.accuracy.step_reasons[interrupted],
            GetParam().exponent == 1 ? reference.contacts : 0); // others go in steps
  EXPECT_LT(distance(whole.state, exact), error);
  EXPECT_NEAR(whole.state[whole.layout.impulse(0)], static_cast<double>(exact[4]), error);
  EXPECT_LT(whole.accuracy.energy_residual, error);
  if (whole.layout.n_sliding == 0)
    return;
  EXPECT_NEAR(whole.state[whole.layout.friction_work(0)], static_cast<double>(exact[5]), error);
  EXPECT_NEAR(whole.state[whole.layout.wear_work(0)],
              static_cast<double>(exact[5]) / GetParam().friction, 10 * error);
  EXPECT_NEAR(whole.state[whole.layout.sliding_way(0)], static_cast<double>(exact[6]), error);
}

} // namespace ring_contacts_tests
} // namespace vibroimpact::motion
