// The list of tangential laws. A new one is one file pair beside this and one line in
// tangential_laws.cc.
#pragma once

#include "contact/friction/tangential_law.h"
#include "parameters/values.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::contact {

/// Declares the section `Friction` of a contact: which law, along which direction, and a section
/// for the constants of each.
void declare_friction(parameters::Section &contact);

/// Has the contact friction?
bool has_friction(const parameters::Values &contact);

/// Along two directions?
bool has_two_directions(const parameters::Values &contact);

/// The law that the section chooses; has_friction(). Throws InputError.
std::shared_ptr<const TangentialLaw> create_tangential_law(const parameters::Values &contact);

/// One warning for each section of another tangential law than the chosen one.
std::vector<std::string> unused_friction_sections(const parameters::Values &contact);

} // namespace vibroimpact::contact
