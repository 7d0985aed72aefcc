// Which contacts the sections "Contact NAME" make: one each, or two that face each other.
#pragma once

#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::contact {

/// The section of a contact, and whether the contact is its mirror image: the Direction reversed,
/// everything else the same.
struct ContactSection {
  parameters::Values values;
  bool mirrored = false;
};

/// Declares the key "Mirrored as".
void declare_mirror(parameters::Section &contact);

/// The contacts of these sections, each followed by its mirror image where it has one. Throws
/// InputError where two contacts would have the same name.
std::vector<std::string> contact_names(const parameters::Values &root,
                                       const std::vector<std::string> &sections);

/// Of a name among contact_names().
ContactSection contact_section(const parameters::Values &root, const std::string &name);

} // namespace vibroimpact::contact
