#include "contact/friction/viscous.h"

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "Viscous";
} // namespace

void Viscous::declare(parameters::Section &friction) {
  using namespace parameters;
  friction
      .subsection(section_name,
                  "Tangential force in proportion to the slip rate, while the sides touch.")
      .quantity("Damping constant", "", dimension::damping, range::positive, "c_t",
                "Tangential force per unit slip rate.")
      .required();
}

namespace {

std::shared_ptr<const TangentialLaw> create_along(const parameters::Values &friction,
                                                  int directions) {
  const parameters::Values law = friction.subsection(section_name);
  law.require("Damping constant");
  return std::make_shared<Viscous>(law.quantity("Damping constant"), directions);
}

} // namespace

std::shared_ptr<const TangentialLaw> Viscous::create(const parameters::Values &friction) {
  return create_along(friction, 1);
}

std::shared_ptr<const TangentialLaw> Viscous::create_planar(const parameters::Values &friction) {
  return create_along(friction, 2);
}

std::vector<TangentialMode> Viscous::modes(const AffineForm & /*normal_force*/,
                                           std::size_t /*first_internal*/) const {
  TangentialMode mode{.name = "viscous"};
  for (int d = 1; d <= directions_; ++d)
    mode.force[static_cast<std::size_t>(d - 1)] = -damping_constant_ * AffineForm::rate_along(d);
  return {mode};
}

} // namespace vibroimpact::contact
