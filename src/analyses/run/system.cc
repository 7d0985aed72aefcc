#include "analyses/run/system.h"

#include "common/error.h"
#include "contact/connection_laws.h"
#include "contact/contact_sections.h"
#include "contact/observed_contacts.h"
#include "model/assembled_system.h"
#include "model/bearing.h"
#include "model/connection.h"
#include "model/excitation.h"
#include "model/rotor_parameters.h"
#include "model/system_damping.h"
#include "motion/system/equilibrium.h"

#include <algorithm>

namespace vibroimpact::analyses {

using contact::ContactSet;
using model::EquilibriumStart;

namespace {

constexpr const char *active_key = "Active contacts";
constexpr const char *observed_key = "Observed contacts";

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

// Adds the equilibrium to the initial state. Contacts that are closed in it may start so.
ContactSet start_in_equilibrium(EquilibriumStart start, const model::Model &model,
                                ContactSet contacts, model::InitialState &initial) {
  const bool with_contacts = start == EquilibriumStart::with_contacts;
  const ContactSet none;
  motion::Equilibrium equilibrium;
  try {
    equilibrium =
        motion::static_equilibrium(model, with_contacts ? contacts : none, model.static_load());
  } catch (const NumericalError &error) {
    throw InputError(std::string("The motion cannot start from its equilibrium: ") + error.what() +
                     model::unheld_motions(model));
  }
  initial.displacement += equilibrium.displacement;
  std::vector<contact::ContactPair> pairs = contacts.pairs();
  for (std::size_t c = 0; with_contacts && c < pairs.size(); ++c)
    pairs[c].accept_initial_penetration |= equilibrium.closed[c];
  return ContactSet(std::move(pairs), contacts.groups());
}

bool contains(const std::vector<std::string> &list, const std::string &name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// Of the contacts that cannot close, those whose gap is recorded.
std::vector<std::string> observed(const parameters::Values &analysis,
                                  const std::vector<std::string> &active,
                                  const std::vector<std::string> &available) {
  std::vector<std::string> others;
  for (const std::string &name : available)
    if (!contains(active, name))
      others.push_back(name);
  const std::vector<std::string> names = analysis.names(observed_key);
  for (const std::string &name : names)
    if (contains(active, name))
      analysis.reject(observed_key, "must not name " + name + ", which is among Active contacts");
  return selected(analysis, observed_key, others);
}

ContactSet selected_contacts(const parameters::Values &root, const parameters::Values &analysis,
                             const model::Model &model) {
  const std::vector<std::string> available =
      contact::contact_names(root, listed_instances(root, "Contacts", "Contact"));
  const std::vector<std::string> active = selected(analysis, active_key, available);
  const std::vector<std::string> without = observed(analysis, active, available);
  std::vector<std::string> names = active;
  names.insert(names.end(), without.begin(), without.end());
  return contact::without_force(contact::read_contacts(root, names, model), without);
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
      .names(active_key, "all", "Contacts that can close: all, none, or their names.")
      .names(observed_key, "none",
             "Contacts that cannot close, and whose gap is recorded as that of the others: none, "
             "all that are not active, or their names.")
      .names("Initial conditions", initial_default,
             "Initial conditions of the first motion: all, none (rest), or their names.");
}

System build_system(const parameters::Values &root, const parameters::Values &analysis,
                    std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies) {
  model::Model model(std::move(bodies));
  model::add_excitations(root, selected(analysis, "Excitations", root.instances("Excitation")),
                         model);
  model::add_spins(root, model);
  model::add_connections(root, model);
  model::add_bearings(root, model);
  model::add_rotors(root, model);
  model::add_system_damping(root, model);
  ContactSet contact_set =
      contact::with_connections(root, model, selected_contacts(root, analysis, model));
  const std::vector<std::string> conditions =
      selected(analysis, "Initial conditions", root.instances("Initial condition"));
  model::InitialState initial = model::read_initial_state(root, conditions, model);
  if (const EquilibriumStart start = model::equilibrium_start(root, conditions);
      start != EquilibriumStart::none)
    contact_set = start_in_equilibrium(start, model, std::move(contact_set), initial);
  return {.model = std::move(model),
          .contacts = std::move(contact_set),
          .integration = motion::read_integration(root),
          .initial = std::move(initial)};
}

} // namespace vibroimpact::analyses
