#include "contact/laws/no_force.h"

namespace vibroimpact::contact {

NoForce::NoForce()
    : ContactLaw({{.name = "open", .in_contact = false, .guards = {}, .affine = AffineLaw{}}}, {}) {
}

void NoForce::evaluate(int /*mode*/, const LocalState & /*state*/, LawResponse &response) const {
  response.force = 0;
  response.force_by_gap = 0;
  response.force_by_gap_rate = 0;
  response.stored_energy = 0;
  response.dissipated_power = 0;
}

} // namespace vibroimpact::contact
