#include "contact/laws/bilinear_stop.h"

#include "contact/laws/given_stiffness.h"

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "Bilinear stop";
} // namespace

BilinearStop::BilinearStop(double stiffness, double damping_constant)
    : ContactLaw(
          open_and_contact(AffineLaw{.force = {.gap = -stiffness, .gap_rate = -damping_constant}}),
          {}),
      stiffness_(stiffness), damping_constant_(damping_constant) {}

void BilinearStop::declare(parameters::Section &contact) {
  using namespace parameters;
  contact
      .subsection(section_name,
                  "Spring and dashpot that act while the points overlap, pulling too: "
                  "F = k u + c u'.")
      .quantity("Stiffness", "", dimension::stiffness, range::non_negative, "k",
                "Contact force per unit penetration.")
      .required("Stiffness fraction is not given")
      .quantity("Damping constant", "0 N s/m", dimension::damping, range::non_negative, "c",
                "Contact force per unit penetration rate.");
}

std::shared_ptr<const ContactLaw> BilinearStop::create(const parameters::Values &contact) {
  const parameters::Values law = contact.subsection(section_name);
  law.require("Stiffness");
  return std::make_shared<BilinearStop>(law.quantity("Stiffness"),
                                        law.quantity("Damping constant"));
}

std::shared_ptr<const ContactLaw> BilinearStop::create_with(const parameters::Values &contact,
                                                            double stiffness) {
  const parameters::Values law = contact.subsection(section_name);
  refuse_stiffness(law);
  return std::make_shared<BilinearStop>(stiffness, law.quantity("Damping constant"));
}

void BilinearStop::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double stiffness = mode == 1 ? stiffness_ : 0;
  const double damping_constant = mode == 1 ? damping_constant_ : 0;
  response.force = -stiffness * state.gap - damping_constant * state.gap_rate;
  response.force_by_gap = -stiffness;
  response.force_by_gap_rate = -damping_constant;
  response.stored_energy = 0.5 * stiffness * state.gap * state.gap;
  response.dissipated_power = damping_constant * state.gap_rate * state.gap_rate;
}

// A dashpot alone has no elastic force.
std::optional<ElasticForce> BilinearStop::elastic_force() const {
  if (stiffness_ == 0)
    return std::nullopt;
  return ElasticForce{.stiffness = stiffness_, .exponent = 1};
}

} // namespace vibroimpact::contact
