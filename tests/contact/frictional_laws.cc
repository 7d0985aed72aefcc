// Laws of friction with every kind of normal law: partial derivatives against differences, and the
// power of both forces against energies.
#include "contact/friction/coulomb.h"
#include "contact/friction/frictional_law.h"
#include "contact/friction/lugre.h"
#include "contact/friction/piecewise_linear.h"
#include "contact/friction/spring_slider.h"
#include "contact/friction/stribeck.h"
#include "contact/friction/viscous.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "contact/laws/tsuji.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace vibroimpact::contact {
namespace frictional_laws_tests {

using Numbers = std::vector<double>;

/// Gap, its rate and acceleration, slip, its rate, then the internal states.
LocalState state_of(const Numbers &x) {
  LocalState state{.gap = x[0], .gap_rate = x[1], .internal = {x.data() + 5, x.size() - 5}};
  state.gap_acceleration = x[2];
  state.tangential[0] = {.slip = x[3], .slip_rate = x[4]};
  return state;
}

/// With the rate of the normal force that belongs to the acceleration.
LawResponse response_at(const ContactLaw &law, int mode, const Numbers &x) {
  LawResponse response;
  LocalState state = state_of(x);
  law.evaluate(mode, state, response);
  state.normal_force_rate = response.force_by_gap * x[1] + response.force_by_gap_rate * x[2];
  for (std::size_t i = 0; i + 5 < x.size(); ++i)
    state.normal_force_rate += response.force_by_internal[i] * response.internal_rate[i];
  law.evaluate(mode, state, response);
  return response;
}

double slope(const Numbers &x, std::size_t i, const std::function<double(const Numbers &)> &value) {
  const auto central = [&](double h) {
    Numbers up = x, down = x;
    up[i] += h;
    down[i] -= h;
    return (value(up) - value(down)) / (2 * h);
  };
  const double h = 1e-3 * std::abs(x[i]);
  return (4 * central(h / 2) - central(h)) / 3;
}

void expect_slopes(const ContactLaw &law, int mode, const Numbers &x) {
  const LawResponse at = response_at(law, mode, x);
  const std::string where = law.name() + ", " + law.modes()[static_cast<std::size_t>(mode)].name;
  const auto near = [&](double found, double expected, double size, const std::string &what) {
    EXPECT_NEAR(found, expected, 1e-7 * (std::abs(expected) + size)) << where << ": " << what;
  };
  const AffineForm &by = at.tangential[0].by;
  const auto n = x.size() - 5;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto internal = [&](std::size_t k) {
      return k < by.internal.size() ? by.internal[k] : 0;
    };
    const double force_slopes[] = {by.gap, by.gap_rate, 0, by.tangential[0].position,
                                   by.tangential[0].rate};
    const double found = i < 5 ? force_slopes[i] : internal(i - 5);
    near(found,
         slope(x, i,
               [&](const Numbers &y) { return response_at(law, mode, y).tangential[0].force; }),
         std::abs(at.tangential[0].force / x[i]), "force by " + std::to_string(i));
    for (std::size_t k = 0; k < n; ++k) {
      const double rate_slopes[] = {at.internal_rate_by_gap[k], at.internal_rate_by_gap_rate[k],
                                    at.internal_rate_by_gap_acceleration[k], 0,
                                    at.tangential[0].internal_rate_by_slip_rate[k]};
      near(
          i < 5 ? rate_slopes[i] : at.internal_rate_by_internal[k * n + i - 5],
          slope(x, i, [&](const Numbers &y) { return response_at(law, mode, y).internal_rate[k]; }),
          std::abs(at.internal_rate[k] / x[i]), "rate by " + std::to_string(i));
    }
  }
}

// -N gap_rate - F v is stored or dissipated.
void expect_power(const ContactLaw &law, int mode, const Numbers &x) {
  const LawResponse at = response_at(law, mode, x);
  const auto energy = [&](const Numbers &y) { return response_at(law, mode, y).stored_energy; };
  double stored = slope(x, 0, energy) * x[1] + slope(x, 1, energy) * x[2];
  for (std::size_t i = 5; i < x.size(); ++i)
    stored += slope(x, i, energy) * at.internal_rate[i - 5];
  const double taken = -at.force * x[1] - at.tangential[0].force * x[4];
  EXPECT_NEAR(taken, stored + at.dissipated_power,
              1e-8 * (std::abs(stored) + std::abs(at.dissipated_power)))
      << law.name() << ", " << law.modes()[static_cast<std::size_t>(mode)].name;
}

std::vector<std::shared_ptr<const ContactLaw>> normal_laws() {
  return {std::make_shared<LinearPenalty>(3e4),
          std::make_shared<KelvinVoigt>(3e4, 90),
          std::make_shared<Hertz>(HertzConstants{.stiffness = 1e5}),
          HuntCrossley::with_dissipation({.stiffness = 1e5}, 0.2),
          HuntCrossley::with_dimensionless_damping({.stiffness = 1e5}, 0.2, 1e-3),
          std::make_shared<KuwabaraKono>(1e5, 1e-3)};
}

std::vector<std::shared_ptr<const TangentialLaw>> tangential_laws() {
  const StribeckConstants stribeck{.coefficient = 0.2,
                                   .static_coefficient = 0.4,
                                   .speed = 0.5,
                                   .exponent = 1.5,
                                   .damping_constant = 2};
  return {std::make_shared<Coulomb>(0.2, 0.3, 4),
          std::make_shared<SpringSlider>(2e4, 0.3, 0),
          std::make_shared<SpringSlider>(2e4, 0.3, 30),
          std::make_shared<Viscous>(3),
          std::make_shared<PiecewiseLinear>(Numbers{0, 0.5, 1}, Numbers{0.4, 0.2, 0.3}, 0.4),
          std::make_shared<Stribeck>(stribeck),
          std::make_shared<LuGre>(LuGreConstants{
              .coefficient = stribeck, .stiffness = 1e3, .damping = 3, .viscous = 0.1})};
}

// What slides is the slip less what deforms.
TEST(FrictionalLaws, DerivativesAndPower) {
  std::mt19937_64 generator(7); // NOLINT(cert-msc51-cpp): the same states in every run
  std::uniform_real_distribution<double> part(0.2, 1);
  for (const auto &normal : normal_laws())
    for (const auto &tangential : tangential_laws()) {
      const FrictionalLaw law(normal, tangential);
      for (int mode = 0; mode < static_cast<int>(law.modes().size()); ++mode) {
        const contact::Mode &of = law.modes()[static_cast<std::size_t>(mode)];
        const double sigma = of.name.find("backward") == std::string::npos ? 1 : -1;
        Numbers x = {-1e-3 * part(generator), -0.5 * part(generator), 40 * part(generator),
                     1e-3 * part(generator), sigma * part(generator)};
        for (int i = 0; i < law.n_internal(); ++i)
          x.push_back(i < normal->n_internal() ? 0.7 : 1e-4 * part(generator));
        expect_slopes(law, mode, x);
        const bool slaved = tangential->stiffness() > 0 && tangential->damping_constant() == 0;
        if (slaved && of.friction == Friction::slip) // the spring follows the normal force
          x.back() = -response_at(law, mode, x).tangential[0].force / tangential->stiffness();
        if (!of.holds_slip && of.in_contact)
          expect_power(law, mode, x);
        if (of.friction == Friction::slip && !tangential->internal_states().empty()) {
          const LawResponse at = response_at(law, mode, x);
          EXPECT_NEAR(std::abs(at.sliding_speed), std::abs(x[4] - at.internal_rate.back()), 1e-12)
              << law.name() << ", " << of.name;
        }
      }
    }
}

TEST(FrictionalLaws, SaysWhatCannotBeCombined) {
  const Coulomb coulomb(0.3, 0.4);
  for (const auto &normal : normal_laws())
    EXPECT_EQ(why_no_friction(*normal, coulomb), "");
  EXPECT_EQ(why_no_friction(Tsuji(1e5, 3), coulomb), "a normal force that may pull,");
  const NewtonRestitution rigid(0.5);
  EXPECT_EQ(why_no_friction(rigid, coulomb), "");
  const std::string reason = "rigid sides (coulomb without Damping constant is possible),";
  EXPECT_EQ(why_no_friction(rigid, Coulomb(0.3, 0.4, 1)), reason);
  EXPECT_EQ(why_no_friction(rigid, Viscous(2)), reason);
}

} // namespace frictional_laws_tests
} // namespace vibroimpact::contact
