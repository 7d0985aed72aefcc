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

std::shared_ptr<const TangentialLaw> Viscous::create(const parameters::Values &friction) {
  const parameters::Values law = friction.subsection(section_name);
  law.require("Damping constant");
  return std::make_shared<Viscous>(law.quantity("Damping constant"));
}

std::vector<TangentialMode> Viscous::modes(const AffineForm & /*normal_force*/,
                                           std::size_t /*first_internal*/) const {
  return {{.name = "viscous", .force = -damping_constant_ * AffineForm::rate_along(1)}};
}

} // namespace vibroimpact::contact
