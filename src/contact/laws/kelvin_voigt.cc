#include "contact/laws/kelvin_voigt.h"

#include "contact/laws/given_stiffness.h"

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Kelvin-Voigt";
constexpr int contact = 1;

std::vector<Mode> make_modes(double stiffness, double damping_constant) {
  const AffineForm force{.gap = -stiffness, .gap_rate = -damping_constant};
  return open_contact_separating(force, AffineLaw{.force = force});
}

} // namespace

KelvinVoigt::KelvinVoigt(double stiffness, double damping_constant)
    : ContactLaw(make_modes(stiffness, damping_constant), {}), stiffness_(stiffness),
      damping_constant_(damping_constant) {}

void KelvinVoigt::declare(parameters::Section &contact_section) {
  using namespace parameters;
  contact_section
      .subsection(section_name, "Spring and dashpot that push but never pull: "
                                "F = max(0, k u + c u').")
      .quantity("Stiffness", "", dimension::stiffness, range::positive, "k",
                "Contact force per unit penetration.")
      .required("Stiffness fraction is not given")
      .quantity("Damping constant", "0 N s/m", dimension::damping, range::non_negative, "c",
                "Contact force per unit penetration rate.");
}

std::shared_ptr<const ContactLaw> KelvinVoigt::create(const parameters::Values &contact_values) {
  const parameters::Values law = contact_values.subsection(section_name);
  law.require("Stiffness");
  return std::make_shared<KelvinVoigt>(law.quantity("Stiffness"), law.quantity("Damping constant"));
}

std::shared_ptr<const ContactLaw> KelvinVoigt::create_with(const parameters::Values &contact_values,
                                                           double stiffness) {
  const parameters::Values law = contact_values.subsection(section_name);
  refuse_stiffness(law);
  return std::make_shared<KelvinVoigt>(stiffness, law.quantity("Damping constant"));
}

void KelvinVoigt::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double stiffness = mode == contact ? stiffness_ : 0;
  const double damping_constant = mode == contact ? damping_constant_ : 0;
  response.force = -stiffness * state.gap - damping_constant * state.gap_rate;
  response.force_by_gap = -stiffness;
  response.force_by_gap_rate = -damping_constant;
  response.stored_energy = 0.5 * stiffness * state.gap * state.gap;
  response.dissipated_power = damping_constant * state.gap_rate * state.gap_rate;
}

} // namespace vibroimpact::contact
