#include "contact/contact_set.h"

#include <algorithm>

namespace vibroimpact::contact {

Direction ContactPair::along(int direction) const {
  if (circle)
    return {.projection = direction == 0 ? &gap : &circle->second(),
            .offset = circle->centres()[static_cast<std::size_t>(direction)]};
  if (direction == 0)
    return {.projection = &gap, .offset = clearance};
  const TangentialDirection &t = tangential[static_cast<std::size_t>(direction - 1)];
  return {.projection = &t.slip, .speed = t.surface_speed};
}

ContactSet::ContactSet(std::vector<ContactPair> pairs, std::vector<ContactGroup> groups)
    : pairs_(std::move(pairs)), groups_(std::move(groups)) {
  for (ContactPair &pair : pairs_) {
    pair.internal_offset = n_internal_;
    n_internal_ += pair.n_internal();
    if (!pair.tangential.empty())
      pair.sliding_place = n_sliding_++;
  }
}

Vector ContactSet::initial_internal() const {
  Vector internal(n_internal_);
  for (const ContactPair &pair : pairs_)
    for (int i = 0; i < pair.n_internal(); ++i)
      internal[pair.internal_offset + i] = pair.law->initial_internal()[i];
  return internal;
}

bool ContactSet::has_circles() const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [](const ContactPair &pair) { return pair.circle != nullptr; });
}

bool ContactSet::has_planes() const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [](const ContactPair &pair) { return pair.tangential.size() == 2; });
}

double ContactSet::effective_mass(std::size_t pair, const model::Model &model,
                                  int direction) const {
  const RowVector &row = pairs_.at(pair).along(direction).projection->row;
  return 1 / (row.cwiseAbs2() * model.mass().cwiseInverse()).value();
}

} // namespace vibroimpact::contact
