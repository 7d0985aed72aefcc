#include "contact/friction/lugre.h"

#include "contact/friction/stick_and_slip.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "LuGre";
enum : int { forward = 0, backward = 1 };
constexpr parameters::Dimension time_over_length{.length = -1, .time = 1};
} // namespace

void LuGre::declare(parameters::Section &friction) {
  using namespace parameters;
  Section &law = friction.subsection(
      section_name,
      "Friction by the deflection of bristles between the surfaces, which slide slowly where "
      "they would stick; all its forces are in proportion to the normal force.");
  declare_stribeck_coefficient(law, "2");
  law.quantity("Bristle stiffness", "", dimension::any, range::positive, "\\sigma_0",
               "Friction force over normal force per unit deflection, in 1/m.")
      .required()
      .quantity("Bristle damping", "0 s/m", dimension::any, range::non_negative, "\\sigma_1",
                "The same per unit rate of deflection, in s/m.")
      .quantity("Viscous coefficient", "0 s/m", dimension::any, range::non_negative, "\\sigma_2",
                "The same per unit slip rate, in s/m.");
}

std::shared_ptr<const TangentialLaw> LuGre::create(const parameters::Values &friction) {
  const parameters::Values law = friction.subsection(section_name);
  law.require("Bristle stiffness");
  return std::make_shared<LuGre>(
      LuGreConstants{.coefficient = read_stribeck_coefficient(law),
                     .stiffness = law.quantity_of("Bristle stiffness", {.length = -1}),
                     .damping = law.quantity_of("Bristle damping", time_over_length),
                     .viscous = law.quantity_of("Viscous coefficient", time_over_length)});
}

std::vector<TangentialMode> LuGre::modes(const AffineForm & /*normal_force*/,
                                         std::size_t /*first_internal*/) const {
  std::vector<TangentialMode> modes = {slip_along(1, backward), slip_along(-1, forward)};
  for (TangentialMode &mode : modes) {
    mode.evaluated = true;
    mode.internal_rate.resize(1);
  }
  return modes;
}

int LuGre::mode_by_slip(int mode, const LocalState &state, std::size_t /*first_internal*/) const {
  const double slip_rate = state.tangential[0].slip_rate;
  return slip_rate > 0 ? forward : slip_rate < 0 ? backward : mode;
}

std::vector<InternalState> LuGre::internal_states() const {
  return {{.name = "friction_deflection",
           .unit = "m",
           .description = "Mean deflection of the bristles along the direction of friction"}};
}

void LuGre::evaluate(int mode, const LocalState &state, std::size_t first_internal,
                     TangentialValues &values) const {
  const auto &[g_of, s0, s1, s2] = constants_;
  const double sigma = mode == forward ? 1 : -1;
  const double v = state.tangential[0].slip_rate;
  const double z = state.internal[first_internal];
  const auto [g, slope] = g_of.at(std::max(0.0, sigma * v));
  const double speed = sigma * v;
  const double rate = v - s0 * speed * z / g;
  const double by_z = -s0 * speed / g;
  const double by_v = 1 - sigma * s0 * z / g * (1 - speed * slope / g);
  values.internal_rate.resize(1);
  values.internal_rate[0] = {.value = rate, .by = {}};
  values.internal_rate[0].by.internal.assign(first_internal + 1, 0.0);
  values.internal_rate[0].by.internal.back() = by_z;
  values.internal_rate[0].by.tangential[0].rate = by_v;
  const double over_force = s0 * z + s1 * rate + s2 * v;
  values.force[0] = {.value = -state.normal_force * over_force,
                     .by = {.normal_force = -over_force}};
  values.force[0].by.internal.assign(first_internal + 1, 0.0);
  values.force[0].by.internal.back() = -state.normal_force * (s0 + s1 * by_z);
  values.force[0].by.tangential[0].rate = -state.normal_force * (s1 * by_v + s2);
  values.sliding_speed = std::abs(s0 * speed * z / g);
}

} // namespace vibroimpact::contact
