#include "contact/laws.h"

#include "contact/friction/tangential_laws.h"
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/constant_force.h"
#include "contact/laws/formula.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/newton_restitution.h"
#include "contact/laws/table.h"
#include "contact/laws/tsuji.h"

#include <stdexcept>

namespace vibroimpact::contact {

namespace {

struct LawEntry {
  const char *name;
  const char *section; ///< with its constants
  void (*declare)(parameters::Section &contact);
  std::shared_ptr<const ContactLaw> (*create)(const parameters::Values &contact);
  /// Of laws with a key Stiffness: with another stiffness than that of the section.
  std::shared_ptr<const ContactLaw> (*create_with)(const parameters::Values &contact,
                                                   double stiffness) = nullptr;
  /// Of laws with a key Effective mass: with this one unless the section gives another.
  std::shared_ptr<const ContactLaw> (*create_of_mass)(const parameters::Values &contact,
                                                      double effective_mass) = nullptr;
  bool always_in_contact = false;
};

constexpr LawEntry laws[] = {
    {"linear penalty", "Linear penalty", LinearPenalty::declare, LinearPenalty::create,
     LinearPenalty::create_with},
    {"kelvin-voigt", "Kelvin-Voigt", KelvinVoigt::declare, KelvinVoigt::create,
     KelvinVoigt::create_with},
    {"kelvin-voigt bumper", "Kelvin-Voigt bumper", KelvinVoigtBumper::declare,
     KelvinVoigtBumper::create},
    {"bilinear stop", "Bilinear stop", BilinearStop::declare, BilinearStop::create,
     BilinearStop::create_with},
    {"hertz", "Hertz", Hertz::declare, Hertz::create},
    {"hunt-crossley", "Hunt-Crossley", HuntCrossley::declare, HuntCrossley::create},
    {"tsuji", "Tsuji", Tsuji::declare, Tsuji::create, nullptr, Tsuji::create_of_mass},
    {"kuwabara-kono", "Kuwabara-Kono", KuwabaraKono::declare, KuwabaraKono::create},
    {"newton restitution", "Newton restitution", NewtonRestitution::declare,
     NewtonRestitution::create},
    {"constant force", "Constant force", ConstantForce::declare, ConstantForce::create, nullptr,
     nullptr, true},
    {"table", "Table", Table::declare, Table::create},
    {"formula", "Formula", FormulaLaw::declare, FormulaLaw::create},
};

const LawEntry &chosen_law(const parameters::Values &contact) {
  const std::string chosen = contact.choice("Law");
  for (const LawEntry &law : laws)
    if (chosen == law.name)
      return law;
  throw std::logic_error("contact law without an entry: " + chosen);
}

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
  return chosen_law(contact).create(contact);
}

std::shared_ptr<const ContactLaw> create_contact_law_of_mass(const parameters::Values &contact,
                                                             double effective_mass) {
  const LawEntry &law = chosen_law(contact);
  return law.create_of_mass == nullptr ? law.create(contact)
                                       : law.create_of_mass(contact, effective_mass);
}

std::shared_ptr<const ContactLaw> create_contact_law(const parameters::Values &contact,
                                                     double stiffness) {
  const LawEntry &law = chosen_law(contact);
  if (law.create_with == nullptr)
    contact.reject("Stiffness fraction",
                   "Stiffness fraction must not be set when Law = " + std::string(law.name) +
                       ", which has no key Stiffness that it could replace.");
  return law.create_with(contact, stiffness);
}

bool has_clearance(const parameters::Values &contact) {
  return !chosen_law(contact).always_in_contact;
}

std::vector<std::string> unused_law_sections(const parameters::Values &contact) {
  const LawEntry &chosen = chosen_law(contact);
  std::vector<std::string> warnings;
  for (const LawEntry &law : laws)
    if (&law != &chosen && contact.subsection_given(law.section))
      warnings.push_back(contact.locate("Law") + ": the section " + law.section +
                         " is not used; it belongs to Law = " + law.name + ".");
  for (std::string &warning : unused_friction_sections(contact))
    warnings.push_back(std::move(warning));
  return warnings;
}

} // namespace vibroimpact::contact
