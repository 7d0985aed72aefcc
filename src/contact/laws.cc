#include "contact/laws.h"

#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "contact/laws/piecewise_stop.h"
#include "contact/laws/relaxing_stop.h"
#include "contact/laws/tsuji.h"

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
    {"kelvin-voigt", KelvinVoigt::declare, KelvinVoigt::create},
    {"relaxing stop", RelaxingStop::declare, RelaxingStop::create},
    {"piecewise stop", PiecewiseStop::declare, PiecewiseStop::create},
    {"hertz", Hertz::declare, Hertz::create},
    {"hunt-crossley", HuntCrossley::declare, HuntCrossley::create},
    {"tsuji", Tsuji::declare, Tsuji::create},
    {"kuwabara-kono", KuwabaraKono::declare, KuwabaraKono::create},
    {"newton restitution", NewtonRestitution::declare, NewtonRestitution::create},
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
