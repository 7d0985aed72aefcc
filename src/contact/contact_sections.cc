#include "contact/contact_sections.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::contact {

using parameters::Values;

namespace {

constexpr const char *mirror_key = "Mirrored as";

bool among(const std::string &name, const std::vector<std::string> &list) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// As names of sections: they stand in paths of results.
bool usable_name(const std::string &name) {
  return std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

void check_mirror(const Values &section, const std::vector<std::string> &taken) {
  const std::string name = section.text(mirror_key);
  if (section.choice("Pairing") != "points")
    section.reject(mirror_key,
                   "Mirrored as must not be set when Pairing = " + section.choice("Pairing") + ".");
  if (!usable_name(name))
    section.reject(mirror_key, "Mirrored as must be a name of letters, digits, '_' and '-'.");
  if (among(name, taken))
    section.reject(mirror_key, "Mirrored as must be a name that no other contact has.");
}

} // namespace

void declare_mirror(parameters::Section &contact) {
  contact.text(mirror_key, "",
               "Name of a second contact, the mirror image of this one: all keys are the same, but "
               "its Direction is the opposite. Empty: there is none.");
}

std::vector<std::string> contact_names(const Values &root,
                                       const std::vector<std::string> &sections) {
  std::vector<std::string> taken = root.instances("Contact");
  std::vector<std::string> names;
  for (const std::string &name : sections) {
    names.push_back(name);
    const Values section = root.instance("Contact", name);
    if (!section.has(mirror_key))
      continue;
    check_mirror(section, taken);
    names.push_back(section.text(mirror_key));
    taken.push_back(names.back());
  }
  return names;
}

ContactSection contact_section(const Values &root, const std::string &name) {
  const std::vector<std::string> sections = root.instances("Contact");
  if (among(name, sections))
    return {.values = root.instance("Contact", name)};
  for (const std::string &section : sections)
    if (root.instance("Contact", section).text(mirror_key) == name)
      return {.values = root.instance("Contact", section), .mirrored = true};
  throw std::logic_error("no section makes a contact " + name);
}

} // namespace vibroimpact::contact
