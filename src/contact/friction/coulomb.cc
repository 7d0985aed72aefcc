#include "contact/friction/coulomb.h"

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Coulomb";
enum : int { stick = 0, forward = 1, backward = 2 };

TangentialMode slip(const std::string &name, double sigma, double coefficient,
                    const AffineForm &normal_force) {
  const AffineForm speed = sigma * AffineForm::rate_along(1);
  return {.name = name,
          .friction = Friction::slip,
          .force = -sigma * coefficient * normal_force,
          .sliding_speed = speed,
          .guards = {{.indicator = speed, .target = stick}}};
}

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
                "The same at which they begin to slip. Without it: Coefficient.");
}

std::shared_ptr<const TangentialLaw> Coulomb::create(const parameters::Values &friction) {
  const parameters::Values law = friction.subsection(section_name);
  law.require("Coefficient");
  const double coefficient = law.quantity("Coefficient");
  const double at_rest =
      law.has("Static coefficient") ? law.quantity("Static coefficient") : coefficient;
  if (at_rest < coefficient)
    law.reject("Static coefficient", "Static coefficient must not be less than Coefficient.");
  return std::make_shared<Coulomb>(coefficient, at_rest);
}

std::vector<TangentialMode> Coulomb::modes(const AffineForm &normal_force,
                                           std::size_t /*first_internal*/) const {
  const AffineForm most = static_coefficient_ * normal_force;
  const AffineForm held = AffineForm::force_along(1);
  return {{.name = "stick",
           .friction = Friction::stick,
           .holds_slip = true,
           .guards = {{.indicator = most + held, .target = forward},
                      {.indicator = most + -1.0 * held, .target = backward}}},
          slip("slip forward", 1, coefficient_, normal_force),
          slip("slip backward", -1, coefficient_, normal_force)};
}

int Coulomb::mode_by_slip(int /*mode*/, double slip_rate) const {
  return slip_rate > 0 ? forward : slip_rate < 0 ? backward : stick;
}

} // namespace vibroimpact::contact
