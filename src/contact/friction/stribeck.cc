#include "contact/friction/stribeck.h"

#include "contact/friction/stick_and_slip.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "Stribeck";
enum : int { stick = 0, forward = 1, backward = 2 };
} // namespace

StribeckConstants::Value StribeckConstants::at(double slip_speed) const {
  const double ratio = slip_speed / speed;
  const double part = (static_coefficient - coefficient) * std::exp(-std::pow(ratio, exponent));
  return {.coefficient = coefficient + part,
          .slope = -part * exponent / speed * std::pow(ratio, exponent - 1)};
}

void declare_stribeck_coefficient(parameters::Section &law, const std::string &exponent) {
  using namespace parameters;
  law.quantity("Coefficient", "", dimension::none, range::positive, "\\mu_k",
               "Friction force over normal force at high slip speed.")
      .required()
      .quantity("Static coefficient", "", dimension::none, range::positive, "\\mu_s",
                "The same at rest.")
      .required()
      .quantity("Stribeck speed", "", dimension::velocity, range::positive, "v_s",
                "Slip speed at which the coefficient has fallen by 63 % of the difference.")
      .required()
      .quantity("Exponent", exponent, dimension::none, Range{.lower = 1, .upper = 4}, "n",
                "Exponent of the ratio of the slip speed to the Stribeck speed.");
}

StribeckConstants read_stribeck_coefficient(const parameters::Values &law) {
  for (const char *key : {"Coefficient", "Static coefficient", "Stribeck speed"})
    law.require(key);
  const StribeckConstants constants{.coefficient = law.quantity("Coefficient"),
                                    .static_coefficient = law.quantity("Static coefficient"),
                                    .speed = law.quantity("Stribeck speed"),
                                    .exponent = law.quantity("Exponent")};
  if (constants.static_coefficient < constants.coefficient)
    law.reject("Static coefficient", "Static coefficient must not be less than Coefficient.");
  return constants;
}

void Stribeck::declare(parameters::Section &friction) {
  using namespace parameters;
  Section &law = friction.subsection(
      section_name, "Friction whose coefficient falls with the slip speed from the static one to "
                    "the coefficient; the sides stick until the force that this takes reaches the "
                    "static coefficient times the normal force.");
  declare_stribeck_coefficient(law, "1");
  law.quantity("Damping constant", "0 N s/m", dimension::damping, range::non_negative, "c_t",
               "Force per unit slip rate that is added while the sides slip.");
}

std::shared_ptr<const TangentialLaw> Stribeck::create(const parameters::Values &friction) {
  const parameters::Values law = friction.subsection(section_name);
  StribeckConstants constants = read_stribeck_coefficient(law);
  constants.damping_constant = law.quantity("Damping constant");
  return std::make_shared<Stribeck>(constants);
}

std::vector<TangentialMode> Stribeck::modes(const AffineForm &normal_force,
                                            std::size_t /*first_internal*/) const {
  std::vector<TangentialMode> modes = {
      stick_until(constants_.static_coefficient * normal_force, forward, backward),
      slip_along(1, stick), slip_along(-1, stick)};
  modes[forward].evaluated = modes[backward].evaluated = true;
  return modes;
}

int Stribeck::mode_by_slip(int /*mode*/, const LocalState &state,
                           std::size_t /*first_internal*/) const {
  const double slip_rate = state.tangential[0].slip_rate;
  return slip_rate > 0 ? forward : slip_rate < 0 ? backward : stick;
}

// The coefficient goes on smoothly where a step looks beyond v = 0.
void Stribeck::evaluate(int mode, const LocalState &state, std::size_t /*first_internal*/,
                        TangentialValues &values) const {
  const double sigma = mode == forward ? 1 : -1;
  const double v = state.tangential[0].slip_rate;
  const auto [coefficient, slope] = constants_.at(std::max(0.0, sigma * v));
  values.force[0].value =
      -sigma * coefficient * state.normal_force - constants_.damping_constant * v;
  values.force[0].by = {.normal_force = -sigma * coefficient};
  values.force[0].by.tangential[0].rate = -slope * state.normal_force - constants_.damping_constant;
  values.sliding_speed = sigma * v;
}

} // namespace vibroimpact::contact
