#include "motion/episode/contact_force.h"

namespace vibroimpact::motion {

Overlap ContactForce::overlap(const Motions &at, int instant) const {
  const auto i = static_cast<std::size_t>(instant);
  return {.penetration = at.places[0][i], .rate = at.rates[0][i]};
}

LawForce::LawForce(const contact::ContactLaw &law, int mode)
    : internal_(law.initial_internal()), law_(law), mode_(mode) {}

contact::LocalState LawForce::local(const Motions &at, int instant) const {
  const auto i = static_cast<std::size_t>(instant);
  return {.gap = -at.places[0][i], .gap_rate = -at.rates[0][i], .internal = internal_};
}

void LawForce::evaluate(int count, const Motions &at, ForceValues &values) const {
  for (int instant = 0; instant < count; ++instant) {
    const auto i = static_cast<std::size_t>(instant);
    if (!(at.places[0][i] > 0)) {
      values.force[0][i] = values.by_place[0][0][i] = values.by_rate[0][0][i] = 0;
      values.dissipated[i] = 0;
      continue;
    }
    law_.evaluate(mode_, local(at, instant), response_);
    values.force[0][i] = response_.force;
    values.by_place[0][0][i] = -response_.force_by_gap;
    values.by_rate[0][0][i] = -response_.force_by_gap_rate;
    values.dissipated[i] = response_.dissipated_power;
  }
}

} // namespace vibroimpact::motion
