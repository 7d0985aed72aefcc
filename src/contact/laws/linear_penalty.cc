#include "contact/laws/linear_penalty.h"

#include "contact/laws/given_stiffness.h"

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "Linear penalty";
} // namespace

LinearPenalty::LinearPenalty(double stiffness)
    : ContactLaw(open_and_contact(AffineLaw{.force = {.gap = -stiffness}}), {}),
      stiffness_(stiffness) {}

void LinearPenalty::declare(parameters::Section &contact) {
  contact.subsection(section_name, "Spring that acts while the points overlap: F = k u.")
      .quantity("Stiffness", "", parameters::dimension::stiffness, parameters::range::positive, "k",
                "Contact force per unit penetration.")
      .required("Stiffness fraction is not given");
}

std::shared_ptr<const ContactLaw> LinearPenalty::create(const parameters::Values &contact) {
  const parameters::Values values = contact.subsection(section_name);
  values.require("Stiffness");
  return std::make_shared<LinearPenalty>(values.quantity("Stiffness"));
}

std::shared_ptr<const ContactLaw> LinearPenalty::create_with(const parameters::Values &contact,
                                                             double stiffness) {
  refuse_stiffness(contact.subsection(section_name));
  return std::make_shared<LinearPenalty>(stiffness);
}

void LinearPenalty::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double stiffness = mode == 1 ? stiffness_ : 0;
  response.force = -stiffness * state.gap;
  response.force_by_gap = -stiffness;
  response.force_by_gap_rate = 0;
  response.stored_energy = 0.5 * stiffness * state.gap * state.gap;
  response.dissipated_power = 0;
}

} // namespace vibroimpact::contact
