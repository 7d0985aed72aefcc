// The list of contact laws. A new law is one file pair in laws/ and one line in laws.cc.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::contact {

/// Declares the choice `Law` and the section of every law in a contact section.
void declare_contact_laws(parameters::Section &contact);

/// The law a contact section chooses. Throws InputError.
std::shared_ptr<const ContactLaw> create_contact_law(const parameters::Values &contact);
/// The same of two sides with this effective mass [kg], for laws that want one and are given none.
/// Throws InputError.
std::shared_ptr<const ContactLaw> create_contact_law_of_mass(const parameters::Values &contact,
                                                             double effective_mass);
/// The same with this stiffness [N/m]. Throws InputError for laws without a key Stiffness.
std::shared_ptr<const ContactLaw> create_contact_law(const parameters::Values &contact,
                                                     double stiffness);

/// Has the chosen law a gap that can open? Else a contact needs no clearance.
bool has_clearance(const parameters::Values &contact);

/// One warning for each section of another law than the chosen one that the contact has.
std::vector<std::string> unused_law_sections(const parameters::Values &contact);

} // namespace vibroimpact::contact
