#include "contact/laws/constant_force.h"

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "Constant force";
} // namespace

ConstantForce::ConstantForce(double force)
    : ContactLaw({{.name = "contact",
                   .in_contact = true,
                   .guards = {},
                   .affine = AffineLaw{.force = {.constant = force}}}},
                 {}),
      force_(force) {}

void ConstantForce::declare(parameters::Section &contact) {
  contact
      .subsection(section_name,
                  "The sides are pressed on each other by a force that never changes, and do not "
                  "part. The clearance does not matter and need not be given.")
      .quantity("Force", "", parameters::dimension::force, parameters::range::positive, "N",
                "Normal force.")
      .required();
}

std::shared_ptr<const ContactLaw> ConstantForce::create(const parameters::Values &contact) {
  const parameters::Values values = contact.subsection(section_name);
  values.require("Force");
  return std::make_shared<ConstantForce>(values.quantity("Force"));
}

// The work of the force on the gap is taken from a store that counts as energy of the contact.
void ConstantForce::evaluate(int /*mode*/, const LocalState &state, LawResponse &response) const {
  response.force = force_;
  response.force_by_gap = 0;
  response.force_by_gap_rate = 0;
  response.stored_energy = -force_ * state.gap;
  response.dissipated_power = 0;
}

} // namespace vibroimpact::contact
