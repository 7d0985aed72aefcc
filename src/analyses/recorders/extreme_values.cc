#include "analyses/recorders/extreme_values.h"

#include "analyses/fields.h"
#include "common/scalar.h"
#include "motion/event/impact_log.h"

namespace vibroimpact::analyses {

using motion::ValueRange;

namespace {

constexpr const char *extreme_values_section = "Extreme values";

void add_bounds(const FieldWriter &result, const ExtremeValueLabels &labels,
                const ValueRange &range) {
  const bool seen = range.maximum >= range.minimum;
  result.number(labels.minimum, seen ? range.minimum : nan);
  result.number(labels.maximum, seen ? range.maximum : nan);
}

} // namespace

ExtremeValueLabels::ExtremeValueLabels(const ObservedQuantity &quantity)
    : peak_to_peak(quantity.path + "/peak_to_peak", quantity.unit,
                   "largest minus smallest value in the recorded window"),
      amplitude(quantity.path + "/amplitude", quantity.unit,
                "half of the largest minus the smallest value in the recorded window"),
      largest(quantity.path + "/largest", quantity.unit,
              "largest absolute value in the recorded window"),
      minimum(quantity.path + "/minimum", quantity.unit,
              "smallest value in the recorded window, " + quantity.meaning),
      maximum(quantity.path + "/maximum", quantity.unit,
              "largest value in the recorded window, " + quantity.meaning) {}

void add_range(const FieldWriter &result, const ExtremeValueLabels &labels,
               const ValueRange &range) {
  result.number(labels.peak_to_peak, range.peak_to_peak());
  result.number(labels.amplitude, range.peak_to_peak() / 2);
  result.number(labels.largest, range.peak());
  add_bounds(result, labels, range);
}

ExtremeValues::ExtremeValues(const ObservedSelection &selection, const System &system)
    : contacts_(system.contacts), quantities_(observed_quantities(selection, system)),
      labels_(quantities_.begin(), quantities_.end()), ranges_(quantities_.size()) {
  for (const ObservedQuantity &quantity : quantities_)
    linear_ = linear_ && quantity.form;
  if (!selection.has("normal_force"))
    return;
  for (const contact::ContactPair &pair : contacts_.pairs())
    force_labels_.emplace_back("contact/" + pair.name + "/normal_force/maximum", "N",
                               "largest normal force in the recorded window");
  forces_.resize(contacts_.size());
}

void ExtremeValues::declare(parameters::Section &analysis) {
  declare_selection_of_quantities(
      analysis.subsection(extreme_values_section, "The recorder of extreme values."));
}

RecorderFactory ExtremeValues::create(const parameters::Values &analysis) {
  const parameters::Values section = analysis.subsection(extreme_values_section);
  const ObservedSelection selection = read_selection_of_quantities(section);
  return [section, selection](const System &system) {
    check_points(selection, system, section);
    return std::make_unique<ExtremeValues>(selection, system);
  };
}

void ExtremeValues::begin(const Window & /*window*/, const motion::Trajectory & /*trajectory*/) {
  std::fill(ranges_.begin(), ranges_.end(), ValueRange{});
  // A contact that stays open has the largest force zero.
  std::fill(forces_.begin(), forces_.end(), ValueRange{.minimum = 0, .maximum = 0});
}

void ExtremeValues::step(const motion::StepView &view) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    ranges_[i].include(quantities_[i].curve(view));
  for (std::size_t c = 0; c < forces_.size(); ++c)
    if (in_contact(view, c))
      forces_[c].include(motion::peak_force(view, c));
}

void ExtremeValues::add_forms(const motion::Equations &equations,
                              std::vector<motion::MonitoredForm> &forms) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    forms.push_back(quantities_[i].form(equations, ranges_[i]));
  for (std::size_t c = 0; c < forces_.size(); ++c)
    if (equations.mode(c).in_contact)
      forms.push_back(motion::monitored_force(equations, c, forces_[c]));
}

void ExtremeValues::add_fields(const FieldWriter &result) const {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    if (quantities_[i].kind == "gap")
      add_bounds(result, labels_[i], ranges_[i]);
    else
      add_range(result, labels_[i], ranges_[i]);
  for (std::size_t c = 0; c < forces_.size(); ++c)
    result.number(force_labels_[c], forces_[c].maximum);
}

} // namespace vibroimpact::analyses
