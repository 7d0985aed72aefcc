#include "contact/observed_contacts.h"

#include "contact/laws/no_force.h"

#include <algorithm>

namespace vibroimpact::contact {

ContactSet without_force(const ContactSet &contacts, const std::vector<std::string> &names) {
  if (names.empty())
    return contacts;
  const auto law = std::make_shared<NoForce>();
  std::vector<ContactPair> pairs = contacts.pairs();
  for (ContactPair &pair : pairs)
    if (std::ranges::count(names, pair.group.empty() ? pair.name : pair.group) > 0) {
      pair.law = law;
      pair.tangential.clear();
      pair.sliding_place = -1;
      pair.least_flexibility_share = 0; // no force depends on it
    }
  return ContactSet(std::move(pairs), contacts.groups());
}

} // namespace vibroimpact::contact
