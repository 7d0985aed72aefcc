#include "contact/friction/coulomb.h"

#include "contact/friction/stick_and_slip.h"

#include <utility>

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Coulomb";
enum : int { stick = 0, forward = 1, backward = 2 };

} // namespace

void Coulomb::declare(parameters::Section &friction) {
  using namespace parameters;
  friction
      .subsection(section_name, "The two sides stick until the force that this takes reaches the "
                                "static coefficient times the normal force; while they slip it is "
                                "the coefficient times the normal force.")
      .quantity("Coefficient", "", dimension::none, range::positive, "\\mu",
                "Friction force over normal force while the sides slip.")
      .required()
      .quantity("Static coefficient", "", dimension::none, range::positive, "\\mu_s",
                "The same at which they begin to slip. Without it: Coefficient.")
      .quantity("Damping constant", "0 N s/m", dimension::damping, range::non_negative, "c_t",
                "Force per unit slip rate that is added while the sides slip.");
}

CoulombConstants read_coulomb(const parameters::Values &friction) {
  const parameters::Values law = friction.subsection(section_name);
  law.require("Coefficient");
  const double coefficient = law.quantity("Coefficient");
  const double at_rest =
      law.has("Static coefficient") ? law.quantity("Static coefficient") : coefficient;
  if (at_rest < coefficient)
    law.reject("Static coefficient", "Static coefficient must not be less than Coefficient.");
  return {.coefficient = coefficient,
          .static_coefficient = at_rest,
          .damping_constant = law.quantity("Damping constant")};
}

std::shared_ptr<const TangentialLaw> Coulomb::create(const parameters::Values &friction) {
  const CoulombConstants law = read_coulomb(friction);
  return std::make_shared<Coulomb>(law.coefficient, law.static_coefficient, law.damping_constant);
}

std::vector<TangentialMode> Coulomb::modes(const AffineForm &normal_force,
                                           std::size_t /*first_internal*/) const {
  std::vector<TangentialMode> modes = {
      stick_until(static_coefficient_ * normal_force, forward, backward), slip_along(1, stick),
      slip_along(-1, stick)};
  for (const auto &[mode, sigma] : {std::pair(forward, 1.0), {backward, -1.0}}) {
    AffineForm &force = modes[static_cast<std::size_t>(mode)].force[0];
    force = -sigma * coefficient_ * normal_force;
    force.tangential[0].rate -= damping_constant_;
  }
  return modes;
}

std::optional<TangentialLaw::Coefficients> Coulomb::coefficients() const {
  if (damping_constant_ > 0)
    return std::nullopt;
  return Coefficients{.sliding = coefficient_, .at_rest = static_coefficient_};
}

int Coulomb::mode_by_slip(int /*mode*/, const LocalState &state,
                          std::size_t /*first_internal*/) const {
  const double slip_rate = state.tangential[0].slip_rate;
  return slip_rate > 0 ? forward : slip_rate < 0 ? backward : stick;
}

} // namespace vibroimpact::contact
