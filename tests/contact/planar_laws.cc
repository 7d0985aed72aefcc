// Laws of friction along two directions with several normal laws: partial derivatives of forces, of
// internal rates and of what is left until a limit against differences, and their power against
// energies.
#include "contact/friction/frictional_law.h"
#include "contact/friction/planar_coulomb.h"
#include "contact/friction/planar_spring_slider.h"
#include "contact/friction/viscous.h"
#include "contact/laws/hertz.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace vibroimpact::contact {
namespace planar_laws_tests {

using Numbers = std::vector<double>;
constexpr std::size_t before_states = 5;

/// With the rate of the normal force that belongs to the acceleration.
struct At {
  LocalState state;
  LawResponse response;
};

/// x: gap, its rate and acceleration, both slip rates, then the internal states.
At at(const ContactLaw &law, int mode, const Numbers &x) {
  At made;
  made.state = {.gap = x[0],
                .gap_rate = x[1],
                .internal = {x.data() + before_states, x.size() - before_states},
                .gap_acceleration = x[2],
                .slow_slip = 2};
  made.state.tangential = {{{.slip_rate = x[3]}, {.slip_rate = x[4]}}};
  LawResponse &response = made.response;
  law.evaluate(mode, made.state, response);
  made.state.normal_force = response.force;
  made.state.normal_force_rate = response.force_by_gap * x[1] + response.force_by_gap_rate * x[2];
  law.evaluate(mode, made.state, response);
  return made;
}

using Value = std::function<double(const At &)>;

double slope(const ContactLaw &law, int mode, const Numbers &x, std::size_t i, const Value &value) {
  const auto central = [&](double h) {
    Numbers up = x, down = x;
    up[i] += h;
    down[i] -= h;
    return (value(at(law, mode, up)) - value(at(law, mode, down))) / (2 * h);
  };
  const double h = 1e-3 * std::abs(x[i]);
  return (4 * central(h / 2) - central(h)) / 3;
}

double coefficient(const AffineForm &form, std::size_t i) {
  const double named[] = {form.gap, form.gap_rate, 0, form.tangential[0].rate,
                          form.tangential[1].rate};
  if (i < before_states)
    return named[i];
  return i - before_states < form.internal.size() ? form.internal[i - before_states] : 0;
}

void expect_slopes(const ContactLaw &law, int mode, const Numbers &x) {
  const LawResponse here = at(law, mode, x).response;
  const std::string where = law.name() + ", " + law.modes()[static_cast<std::size_t>(mode)].name;
  const auto expect = [&](std::size_t i, double found, const Value &value) {
    const double expected = slope(law, mode, x, i, value);
    EXPECT_NEAR(found, expected,
                1e-7 * (std::abs(expected) + std::abs(value(at(law, mode, x)) / x[i])))
        << where << ": by " << i;
  };
  const Value force_rate = [](const At &a) { return a.state.normal_force_rate; };
  const Value force = [](const At &a) { return a.response.force; };
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k)
      expect(i, coefficient(here.tangential[k].by, i),
             [k](const At &a) { return a.response.tangential[k].force; });
    for (std::size_t k = 0; k < here.internal_rate.size(); ++k) {
      const AffineForm by{
          .gap = here.internal_rate_by_gap[k],
          .gap_rate = here.internal_rate_by_gap_rate[k],
          .internal = {here.internal_rate_by_internal.begin() +
                           static_cast<std::ptrdiff_t>(k * here.internal_rate.size()),
                       here.internal_rate_by_internal.begin() +
                           static_cast<std::ptrdiff_t>((k + 1) * here.internal_rate.size())},
          .tangential = {{{.rate = here.tangential[0].internal_rate_by_slip_rate[k]},
                          {.rate = here.tangential[1].internal_rate_by_slip_rate[k]}}}};
      expect(i, i == 2 ? here.internal_rate_by_gap_acceleration[k] : coefficient(by, i),
             [k](const At &a) { return a.response.internal_rate[k]; });
    }
    const AffineForm &by = here.margin_by;
    expect(i,
           coefficient(by, i) + by.normal_force * slope(law, mode, x, i, force) +
               by.normal_force_rate * slope(law, mode, x, i, force_rate),
           [](const At &a) { return a.response.margin; });
  }
}

// -N gap_rate - F . v is stored or dissipated.
void expect_power(const ContactLaw &law, int mode, const Numbers &x) {
  const LawResponse here = at(law, mode, x).response;
  const Value energy = [](const At &a) { return a.response.stored_energy; };
  double stored = slope(law, mode, x, 0, energy) * x[1];
  for (std::size_t i = before_states; i < x.size(); ++i)
    stored += slope(law, mode, x, i, energy) * here.internal_rate[i - before_states];
  const double taken =
      -here.force * x[1] - here.tangential[0].force * x[3] - here.tangential[1].force * x[4];
  EXPECT_NEAR(taken, stored + here.dissipated_power,
              1e-8 * (std::abs(stored) + std::abs(here.dissipated_power)))
      << law.name() << ", " << law.modes()[static_cast<std::size_t>(mode)].name;
}

TEST(PlanarLaws, DerivativesAndPower) {
  const std::vector<std::shared_ptr<const ContactLaw>> normals = {
      std::make_shared<LinearPenalty>(3e4), std::make_shared<KelvinVoigt>(3e4, 90),
      std::make_shared<Hertz>(HertzConstants{.stiffness = 1e5}),
      std::make_shared<KuwabaraKono>(1e5, 1e-3)};
  const std::vector<std::shared_ptr<const TangentialLaw>> frictions = {
      std::make_shared<PlanarCoulomb>(
          CoulombConstants{.coefficient = 0.2, .static_coefficient = 0.3, .damping_constant = 4}),
      std::make_shared<PlanarSpringSlider>(
          SpringSliderConstants{.stiffness = 2e4, .coefficient = 0.3}),
      std::make_shared<PlanarSpringSlider>(
          SpringSliderConstants{.stiffness = 2e4, .coefficient = 0.3, .damping_constant = 30}),
      std::make_shared<Viscous>(3, 2)};
  std::mt19937_64 generator(11); // NOLINT(cert-msc51-cpp): the same states in every run
  std::uniform_real_distribution<double> part(0.2, 1);
  for (const auto &normal : normals)
    for (const auto &friction : frictions) {
      const FrictionalLaw law(normal, friction);
      EXPECT_EQ(law.n_tangential(), 2);
      for (int mode = 0; mode < static_cast<int>(law.modes().size()); ++mode) {
        Numbers x = {-1e-3 * part(generator), -0.5 * part(generator), 40 * part(generator),
                     part(generator), -part(generator)};
        for (int i = 0; i < law.n_internal(); ++i)
          x.push_back((i % 2 == 0 ? 1e-3 : -1e-3) * part(generator));
        expect_slopes(law, mode, x);
        const Mode &of = law.modes()[static_cast<std::size_t>(mode)];
        if (!of.holds_slip && of.in_contact)
          expect_power(law, mode, x);
      }
    }
}

// Where a spring-slider sticks, the margin is that of the circle mu N.
TEST(PlanarLaws, LimitOfStick) {
  const FrictionalLaw law(std::make_shared<LinearPenalty>(1e4),
                          std::make_shared<PlanarSpringSlider>(SpringSliderConstants{
                              .stiffness = 2e4, .coefficient = 0.5, .damping_constant = 10}));
  const Numbers internal = {1e-4, -2e-4};
  LocalState state{.gap = -1e-3, .internal = internal};
  state.tangential = {{{.slip_rate = 0.1}, {.slip_rate = 0.2}}};
  const LimitCircle &limit = law.modes()[1].limit.value();
  EXPECT_NEAR(limit(state), 25 - 3 * 3 - 2 * 2, 1e-12);
  state.margin = limit.gradient(state)(state);
  EXPECT_NEAR(state.margin, 2 * limit(state), 1e-12); // a sum of squares
}

} // namespace planar_laws_tests
} // namespace vibroimpact::contact
