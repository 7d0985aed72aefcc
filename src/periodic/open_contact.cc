#include "periodic/open_contact.h"

#include <algorithm>

namespace vibroimpact::periodic {

using contact::ContactLaw;
using contact::ContactPair;
using contact::ContactSet;
using contact::Guard;
using contact::Mode;

namespace {

std::vector<Mode> without_closing(const ContactLaw &law) {
  std::vector<Mode> modes = law.modes();
  for (Mode &mode : modes)
    if (!mode.in_contact)
      std::erase_if(mode.guards, [&](const Guard &guard) { return closes(law, guard); });
  return modes;
}

std::vector<Mode> without_guard(const ContactLaw &law, const Overlooked &overlooked) {
  std::vector<Mode> modes = law.modes();
  std::vector<Guard> &guards = modes[static_cast<std::size_t>(overlooked.kept_mode)].guards;
  guards.erase(guards.begin() + static_cast<std::ptrdiff_t>(overlooked.guard));
  return modes;
}

} // namespace

bool closes(const ContactLaw &law, const Guard &guard) {
  return guard.action == contact::GuardAction::impact ||
         law.modes()[static_cast<std::size_t>(guard.target)].in_contact;
}

OpenContact::OpenContact(std::shared_ptr<const ContactLaw> law)
    : OverlookingContact(law, without_closing(*law)) {}

int OpenContact::initial_mode(const contact::LocalState &state) const {
  const int mode = OverlookingContact::initial_mode(state);
  if (!modes()[static_cast<std::size_t>(mode)].in_contact)
    return mode;
  const auto open = std::find_if(modes().begin(), modes().end(),
                                 [](const Mode &other) { return !other.in_contact; });
  return static_cast<int>(open - modes().begin());
}

KeptContact::KeptContact(std::shared_ptr<const ContactLaw> law, const Overlooked &overlooked)
    : OverlookingContact(law, without_guard(*law, overlooked)), mode_(overlooked.kept_mode) {}

ContactSet overlooking(const ContactSet &contacts, const Overlooked &overlooked) {
  std::vector<ContactPair> pairs = contacts.pairs();
  std::shared_ptr<const ContactLaw> &law = pairs[overlooked.contact].law;
  if (overlooked.kept_mode < 0)
    law = std::make_shared<OpenContact>(law);
  else
    law = std::make_shared<KeptContact>(law, overlooked);
  return ContactSet(std::move(pairs), contacts.groups());
}

} // namespace vibroimpact::periodic
