#include "contact/laws.h"

#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"

#include <stdexcept>

namespace vibroimpact {

namespace {

struct LawEntry {
  const char *name;
  void (*declare)(parameters::Section &contact);
  std::shared_ptr<const ContactLaw> (*create)(const parameters::Values &contact);
};

constexpr LawEntry laws[] = {
    {"linear penalty", LinearPenalty::declare, LinearPenalty::create},
    {"hertz", Hertz::declare, Hertz::create},
    {"hunt-crossley", HuntCrossley::declare, HuntCrossley::create},
};

} // namespace

void declare_contact_laws(parameters::Section &contact) {
  std::vector<std::string> names;
  for (const LawEntry &law : laws)
    names.emplace_back(law.name);
  contact.choice("Law", names.front(), names,
                 "Contact law; its constants stand in its own section.");
  for (const LawEntry &law : laws)
    law.declare(contact);
}

std::shared_ptr<const ContactLaw> create_contact_law(const parameters::Values &contact) {
  const std::string chosen = contact.choice("Law");
  for (const LawEntry &law : laws)
    if (chosen == law.name)
      return law.create(contact);
  throw std::logic_error("contact law without an entry: " + chosen);
}

} // namespace vibroimpact
