#include "motion/episode/contact_force.h"

namespace vibroimpact::motion {

LawForce::LawForce(const contact::ContactLaw &law, int mode)
    : law_(law), mode_(mode), internal_(law.initial_internal()) {}

void LawForce::evaluate(int count, const double *penetration, const double *rate,
                        ForceValues &values) const {
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!(penetration[i] > 0)) {
      values.force[at] = values.by_penetration[at] = values.by_rate[at] = 0;
      values.dissipated[at] = 0;
      continue;
    }
    law_.evaluate(mode_, {.gap = -penetration[i], .gap_rate = -rate[i], .internal = internal_},
                  response_);
    values.force[at] = response_.force;
    values.by_penetration[at] = -response_.force_by_gap;
    values.by_rate[at] = -response_.force_by_gap_rate;
    values.dissipated[at] = response_.dissipated_power;
  }
}

} // namespace vibroimpact::motion
