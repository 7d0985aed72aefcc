#include "analyses/recorders/excursions.h"

#include "analyses/fields.h"
#include "integration/impact_log.h"

#include <limits>

namespace vibroimpact {

namespace {

constexpr const char *section_name = "Excursions";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void add_bounds(PointResult &result, const WatchedQuantity &quantity, const Extent &extent) {
  const bool seen = extent.maximum >= extent.minimum;
  result.fields.push_back(
      scalar_field(quantity.path + "/minimum", seen ? extent.minimum : nan, quantity.unit,
                   "smallest value in the recorded window, " + quantity.meaning));
  result.fields.push_back(
      scalar_field(quantity.path + "/maximum", seen ? extent.maximum : nan, quantity.unit,
                   "largest value in the recorded window, " + quantity.meaning));
}

} // namespace

void add_extent(PointResult &result, const WatchedQuantity &quantity, const Extent &extent) {
  result.fields.push_back(scalar_field(quantity.path + "/peak_to_peak_excursion",
                                       extent.peak_to_peak(), quantity.unit,
                                       "largest minus smallest value in the recorded window"));
  result.fields.push_back(scalar_field(quantity.path + "/peak_excursion", extent.peak(),
                                       quantity.unit,
                                       "largest absolute value in the recorded window"));
  add_bounds(result, quantity, extent);
}

Excursions::Excursions(const WatchedSelection &selection, const System &system)
    : contacts_(system.contacts), quantities_(watched_quantities(selection, system)),
      extents_(quantities_.size()) {
  // A contact that stays open has the largest force zero.
  if (selection.has("normal_force"))
    forces_.resize(contacts_.size(), {.minimum = 0, .maximum = 0});
  for (const WatchedQuantity &quantity : quantities_)
    linear_ = linear_ && quantity.form;
}

void Excursions::declare(parameters::Section &analysis) {
  declare_selection_of_quantities(
      analysis.subsection(section_name, "The recorder of extreme values."));
}

RecorderFactory Excursions::create(const parameters::Values &analysis) {
  const parameters::Values section = analysis.subsection(section_name);
  const WatchedSelection selection = read_selection_of_quantities(section);
  return [section, selection](const System &system) {
    check_points(selection, system, section);
    return std::make_unique<Excursions>(selection, system);
  };
}

void Excursions::step(const StepView &view) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    extents_[i].include(quantities_[i].curve(view));
  for (std::size_t c = 0; c < forces_.size(); ++c)
    if (in_contact(view, c))
      forces_[c].include(peak_force(view, c));
}

void Excursions::watch(const Equations &equations, std::vector<WatchedForm> &forms) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    forms.push_back(quantities_[i].form(equations, extents_[i]));
  for (std::size_t c = 0; c < forces_.size(); ++c)
    if (const Mode &mode = equations.mode(c); mode.in_contact)
      forms.push_back(watched_contact(equations, c, mode.affine->force, forces_[c]));
}

void Excursions::add_fields(PointResult &result) const {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    if (quantities_[i].kind == "gap")
      add_bounds(result, quantities_[i], extents_[i]);
    else
      add_extent(result, quantities_[i], extents_[i]);
  for (std::size_t c = 0; c < forces_.size(); ++c)
    result.fields.push_back(
        scalar_field("contact/" + contacts_.pairs()[c].name + "/normal_force/maximum",
                     forces_[c].maximum, "N", "largest normal force in the recorded window"));
}

} // namespace vibroimpact
