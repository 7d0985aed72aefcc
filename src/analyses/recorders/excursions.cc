#include "analyses/recorders/excursions.h"

#include "analyses/fields.h"
#include "integration/impact_log.h"

#include <limits>

namespace vibroimpact::analyses {

using integration::Extent;

namespace {

constexpr const char *section_name = "Excursions";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void add_bounds(PointResult &result, const ExtentLabels &labels, const Extent &extent) {
  const bool seen = extent.maximum >= extent.minimum;
  result.fields.push_back(scalar_field(labels.minimum, seen ? extent.minimum : nan));
  result.fields.push_back(scalar_field(labels.maximum, seen ? extent.maximum : nan));
}

} // namespace

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
  for (const WatchedQuantity &quantity : quantities_)
    linear_ = linear_ && quantity.form;
  if (!selection.has("normal_force"))
    return;
  for (const contact::ContactPair &pair : contacts_.pairs())
    force_labels_.emplace_back("contact/" + pair.name + "/normal_force/maximum", "N",
                               "largest normal force in the recorded window");
  forces_.resize(contacts_.size());
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

void Excursions::begin(const Window & /*window*/, const integration::Trajectory & /*trajectory*/) {
  std::fill(extents_.begin(), extents_.end(), Extent{});
  // A contact that stays open has the largest force zero.
  std::fill(forces_.begin(), forces_.end(), Extent{.minimum = 0, .maximum = 0});
}

void Excursions::step(const integration::StepView &view) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    extents_[i].include(quantities_[i].curve(view));
  for (std::size_t c = 0; c < forces_.size(); ++c)
    if (in_contact(view, c))
      forces_[c].include(integration::peak_force(view, c));
}

void Excursions::watch(const integration::Equations &equations,
                       std::vector<integration::WatchedForm> &forms) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    forms.push_back(quantities_[i].form(equations, extents_[i]));
  for (std::size_t c = 0; c < forces_.size(); ++c)
    if (const contact::Mode &mode = equations.mode(c); mode.in_contact)
      forms.push_back(integration::watched_contact(equations, c, mode.affine->force, forces_[c]));
}

void Excursions::add_fields(PointResult &result) const {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    if (quantities_[i].kind == "gap")
      add_bounds(result, labels_[i], extents_[i]);
    else
      add_extent(result, labels_[i], extents_[i]);
  for (std::size_t c = 0; c < forces_.size(); ++c)
    result.fields.push_back(scalar_field(force_labels_[c], forces_[c].maximum));
}

} // namespace vibroimpact::analyses
