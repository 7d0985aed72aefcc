#include "contact/contact_set.h"

namespace vibroimpact::contact {

ContactSet::ContactSet(std::vector<ContactPair> pairs, std::vector<ContactGroup> groups)
    : pairs_(std::move(pairs)), groups_(std::move(groups)) {
  for (ContactPair &pair : pairs_) {
    pair.internal_offset = n_internal_;
    n_internal_ += pair.n_internal();
  }
}

Vector ContactSet::initial_internal() const {
  Vector internal(n_internal_);
  for (const ContactPair &pair : pairs_)
    for (int i = 0; i < pair.n_internal(); ++i)
      internal[pair.internal_offset + i] = pair.law->initial_internal()[i];
  return internal;
}

double ContactSet::effective_mass(std::size_t pair, const model::Model &model) const {
  const RowVector &row = pairs_.at(pair).gap.row;
  return 1 / (row.cwiseAbs2() * model.mass().cwiseInverse()).value();
}

} // namespace vibroimpact::contact
