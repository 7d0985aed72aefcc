#include "analyses/system.h"

#include "model/excitation.h"

namespace vibroimpact {

namespace {

// `key` of the analysis: all (of the file), none, or names.
std::vector<std::string> selected(const parameters::Values &analysis, const std::string &key,
                                  const std::vector<std::string> &available) {
  const std::vector<std::string> names = analysis.names(key);
  if (names.size() == 1 && names[0] == "all")
    return available;
  if (names.empty() || (names.size() == 1 && names[0] == "none"))
    return {};
  for (const std::string &name : names)
    analysis.require_known(key, name, available);
  return names;
}

} // namespace

std::vector<std::string> listed_instances(const parameters::Values &root, const std::string &key,
                                          const std::string &kind) {
  const std::vector<std::string> available = root.instances(kind);
  const std::vector<std::string> listed = root.names(key);
  for (const std::string &name : listed)
    root.require_known(key, name, available);
  return listed.empty() ? available : listed;
}

void declare_selection(parameters::Section &analysis, const std::string &initial_default) {
  analysis.names("Excitations", "all", "Excitations that act: all, none, or their names.")
      .names("Active contacts", "all", "Contacts that can close: all, none, or their names.")
      .names("Initial conditions", initial_default,
             "Initial conditions of the first motion: all, none (rest), or their names.");
}

System build_system(const parameters::Values &root, const parameters::Values &analysis,
                    std::vector<std::shared_ptr<const ReducedBody>> bodies) {
  Model model(std::move(bodies));
  add_excitations(root, selected(analysis, "Excitations", root.instances("Excitation")), model);
  const std::vector<std::string> contacts = listed_instances(root, "Contacts", "Contact");
  ContactSet contact_set =
      read_contacts(root, selected(analysis, "Active contacts", contacts), model);
  InitialState initial = read_initial_state(
      root, selected(analysis, "Initial conditions", root.instances("Initial condition")), model);
  return {.model = std::move(model),
          .contacts = std::move(contact_set),
          .integration = read_integration(root),
          .initial = std::move(initial)};
}

} // namespace vibroimpact
