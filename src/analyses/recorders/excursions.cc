#include "analyses/recorders/excursions.h"

#include "analyses/fields.h"
#include "integration/impact_log.h"

#include <algorithm>
#include <cmath>

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

void Extent::include(double value) {
  minimum = std::min(minimum, value);
  maximum = std::max(maximum, value);
}

void Extent::include(const Bernstein &polynomial) {
  minimum = std::min(minimum, polynomial.minimum());
  maximum = std::max(maximum, polynomial.maximum());
}

double Extent::peak_to_peak() const { return maximum >= minimum ? maximum - minimum : nan; }

double Extent::peak() const {
  return maximum >= minimum ? std::max(std::abs(minimum), std::abs(maximum)) : nan;
}

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
  if (selection.has("normal_force"))
    largest_force_.resize(contacts_.size(), 0);
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
  for (std::size_t c = 0; c < largest_force_.size(); ++c)
    if (in_contact(view, c))
      largest_force_[c] = std::max(largest_force_[c], peak_force(view, c));
}

void Excursions::add_fields(PointResult &result) const {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    if (quantities_[i].kind == "gap")
      add_bounds(result, quantities_[i], extents_[i]);
    else
      add_extent(result, quantities_[i], extents_[i]);
  for (std::size_t c = 0; c < largest_force_.size(); ++c)
    result.fields.push_back(
        scalar_field("contact/" + contacts_.pairs()[c].name + "/normal_force/maximum",
                     largest_force_[c], "N", "largest normal force in the recorded window"));
}

} // namespace vibroimpact
