#include "analyses/recorders/excursions.h"

#include "analyses/fields.h"
#include "integration/impact_log.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact {

namespace {

constexpr const char *section_name = "Excursions";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void add_bounds(PointResult &result, const ExtentLabels &labels, const Extent &extent) {
  const bool seen = extent.maximum >= extent.minimum;
  result.fields.push_back(scalar_field(labels.minimum, seen ? extent.minimum : nan));
  result.fields.push_back(scalar_field(labels.maximum, seen ? extent.maximum : nan));
}

} // namespace

void Extent::include(double value) {
  minimum = std::min(minimum, value);
  maximum = std::max(maximum, value);
}

// Most steps stay within what was seen before, as their coefficients tell at once.
void Extent::include(const Bernstein &polynomial) {
  if (polynomial.lower_bound() < minimum)
    minimum = std::min(minimum, polynomial.minimum());
  Bernstein negative = polynomial;
  negative *= -1;
  if (-negative.lower_bound() > maximum)
    maximum = std::max(maximum, polynomial.maximum());
}

double Extent::peak_to_peak() const { return maximum >= minimum ? maximum - minimum : nan; }

double Extent::peak() const {
  return maximum >= minimum ? std::max(std::abs(minimum), std::abs(maximum)) : nan;
}

ExtentLabels::ExtentLabels(const WatchedQuantity &quantity)
    : peak_to_peak(quantity.path + "/peak_to_peak_excursion", quantity.unit,
                   "largest minus smallest value in the recorded window"),
      peak(quantity.path + "/peak_excursion", quantity.unit,
           "largest absolute value in the recorded window"),
      minimum(quantity.path + "/minimum", quantity.unit,
              "smallest value in the recorded window, " + quantity.meaning),
      maximum(quantity.path + "/maximum", quantity.unit,
              "largest value in the recorded window, " + quantity.meaning) {}

void add_extent(PointResult &result, const ExtentLabels &labels, const Extent &extent) {
  result.fields.push_back(scalar_field(labels.peak_to_peak, extent.peak_to_peak()));
  result.fields.push_back(scalar_field(labels.peak, extent.peak()));
  add_bounds(result, labels, extent);
}

Excursions::Excursions(const WatchedSelection &selection, const System &system)
    : contacts_(system.contacts), quantities_(watched_quantities(selection, system)),
      labels_(quantities_.begin(), quantities_.end()), extents_(quantities_.size()) {
  if (!selection.has("normal_force"))
    return;
  for (const ContactPair &pair : contacts_.pairs())
    force_labels_.emplace_back("contact/" + pair.name + "/normal_force/maximum", "N",
                               "largest normal force in the recorded window");
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

void Excursions::begin(const Window & /*window*/, const Trajectory & /*trajectory*/) {
  std::fill(extents_.begin(), extents_.end(), Extent{});
  std::fill(largest_force_.begin(), largest_force_.end(), 0);
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
      add_bounds(result, labels_[i], extents_[i]);
    else
      add_extent(result, labels_[i], extents_[i]);
  for (std::size_t c = 0; c < largest_force_.size(); ++c)
    result.fields.push_back(scalar_field(force_labels_[c], largest_force_[c]));
}

} // namespace vibroimpact
