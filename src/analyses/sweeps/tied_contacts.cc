#include "analyses/sweeps/tied_contacts.h"

#include "analyses/recorders/observables.h"

namespace vibroimpact::analyses {

namespace {

constexpr const char *tied_key = "Tied contacts";

} // namespace

void declare_tied_contacts(parameters::Section &section) {
  section.names(tied_key, "none",
                "Contacts whose two sides move together along the normal, as if they never opened "
                "and did not yield; the others are open. all, none, or names of active "
                "contacts.");
}

TiedContacts read_tied_contacts(const parameters::Values &section) {
  return [section](const System &system) {
    std::vector<model::Projection> gaps;
    for (const std::size_t c : chosen_contacts(section, tied_key, system)) {
      const contact::ContactPair &pair = system.contacts.pairs()[c];
      if (pair.circle)
        section.reject(tied_key, "must name contacts with Gap = plane; the gap of " + pair.name +
                                     " is circular");
      gaps.push_back(pair.gap);
    }
    return gaps;
  };
}

Matrix rows_of(const std::vector<model::Projection> &gaps, Index n) {
  Matrix rows(static_cast<Index>(gaps.size()), n);
  for (std::size_t k = 0; k < gaps.size(); ++k)
    rows.row(static_cast<Index>(k)) = gaps[k].row;
  return rows;
}

} // namespace vibroimpact::analyses
