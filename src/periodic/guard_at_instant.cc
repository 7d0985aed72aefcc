#include "periodic/guard_at_instant.h"

#include "motion/interval/guard_forms.h"
#include "motion/variation/row_rate.h"

#include <algorithm>

namespace vibroimpact::periodic {

GuardAtInstant::GuardAtInstant(const StroboscopicMap &map, const StroboscopicMap &kept,
                               const Overlooked &of, double phase, const Vector &state)
    : map_{map}, kept_{kept}, contact_{of.contact}, mode_{static_cast<std::size_t>(of.kept_mode)},
      guard_{of.guard}, phase_{phase}, state_{state} {
  kept_.start(phase_, state_);
  local_ = equations().local_state(contact_, time(), this->state());
}

RowVector GuardAtInstant::gradient() const {
  return motion::tangent_row(equations(), contact_, form(), time(), state_).row.head(state_.size());
}

double GuardAtInstant::rate(const Vector &rates) const {
  return motion::rate_of_row(equations(),
                             motion::tangent_row(equations(), contact_, form(), time(), state_).row,
                             time(), rates);
}

RowVector GuardAtInstant::by_keys(const Matrix &state_by_keys) const {
  const auto pick_form = [this](const contact::ContactLaw &law) -> const contact::AffineForm & {
    return pick(law).indicator;
  };
  RowVector row = gradient() * state_by_keys;
  for (Index k = 0; k < row.size(); ++k) {
    ForcedKey &key = *map_.keys()[static_cast<std::size_t>(k)];
    key.tangent.enter(time(), equations().source_break()); // no motion of this map may lead here
    row[k] += key.tangent.form(equations(), contact_, pick_form, time(), state_);
  }
  return row;
}

} // namespace vibroimpact::periodic
