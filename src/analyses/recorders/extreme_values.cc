#include "analyses/recorders/extreme_values.h"

#include "analyses/derivatives/tangent_motion.h"
#include "analyses/results/fields.h"
#include "common/scalar.h"

#include <cmath>

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

ExtremeValueLabels::ExtremeValueLabels(const Observable &observed)
    : peak_to_peak(observed.path + "/peak_to_peak", observed.unit,
                   "largest minus smallest value in the recorded window"),
      amplitude(observed.path + "/amplitude", observed.unit,
                "half of the largest minus the smallest value in the recorded window"),
      largest(observed.path + "/largest", observed.unit,
              "largest absolute value in the recorded window"),
      minimum(observed.path + "/minimum", observed.unit,
              "smallest value in the recorded window, " + observed.description()),
      maximum(observed.path + "/maximum", observed.unit,
              observed.is_force()
                  ? "largest normal force in the recorded window"
                  : "largest value in the recorded window, " + observed.description()) {}

void add_range(const FieldWriter &result, const ExtremeValueLabels &labels,
               const ValueRange &range) {
  result.number(labels.peak_to_peak, range.peak_to_peak());
  result.number(labels.amplitude, range.peak_to_peak() / 2);
  result.number(labels.largest, range.peak());
  add_bounds(result, labels, range);
}

ExtremeValues::ExtremeValues(const ObservedSelection &selection, const System &system)
    : observables_(observables(selection, system)), ranges_(observables_.size()) {
  put_forces_last(observables_);
  for (const Observable &observed : observables_) {
    labels_.emplace_back(observed);
    linear_ = linear_ && observed.is_linear();
  }
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
  // A contact that stays open has the largest force zero.
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    ranges_[i] = observables_[i].is_force() ? ValueRange{.minimum = 0, .maximum = 0} : ValueRange{};
  std::fill(extrema_.begin(), extrema_.end(), Extrema{});
}

void ExtremeValues::outputs(const motion::Equations &equations, std::vector<motion::Output> &list) {
  for (std::size_t i = 0; i < observables_.size(); ++i)
    if (extrema_.empty() && is_seen(observables_[i], equations))
      list.push_back({&observables_[i].form, &ranges_[i]});
}

void ExtremeValues::step(const motion::StepView &view) {
  for (std::size_t i = 0; i < extrema_.size(); ++i)
    if (is_seen(observables_[i], view.equations()))
      include(extrema_[i], observables_[i], view);
}

void ExtremeValues::include(Extrema &extrema, const Observable &observed,
                            const motion::StepView &view) const {
  if (const auto *force = std::get_if<motion::ForceForm>(&observed.form))
    return extrema.largest.include_force(view, force->contact);
  motion::Bernstein along_step = curve(observed.form, view);
  extrema.largest.include(view, along_step);
  along_step *= -1;
  extrema.smallest.include(view, along_step);
}

void ExtremeValues::add_fields(const FieldWriter &result) const {
  for (std::size_t i = 0; i < observables_.size(); ++i)
    if (observables_[i].is_force())
      result.number(labels_[i].maximum, ranges_[i].maximum);
    else if (observables_[i].kind == "gap")
      add_bounds(result, labels_[i], ranges_[i]);
    else
      add_range(result, labels_[i], ranges_[i]);
}

bool ExtremeValues::keeps_extrema() {
  extrema_.resize(observables_.size());
  return !extrema_.empty();
}

std::vector<ObservedExtremum> ExtremeValues::extrema() const {
  std::vector<ObservedExtremum> list;
  for (std::size_t i = 0; i < observables_.size(); ++i) {
    if (observables_[i].is_linear())
      list.push_back({&extrema_[i].largest, observables_[i], Bound::largest});
    if (observables_[i].is_linear() && !observables_[i].is_force())
      list.push_back({&extrema_[i].smallest, observables_[i], Bound::smallest});
  }
  return list;
}

// NaN where the motion has other values than its steps; what has no closed form is left out.
void ExtremeValues::add_tangents(const TangentMotion &motion, const FieldWriter &result) const {
  const ExtremeTangents &known = motion.extremes;
  for (std::size_t i = 0; i < observables_.size(); ++i) {
    const auto &[largest, smallest] = extrema_[i];
    const double above = largest.value, below = smallest.value;
    const double range = std::max(above + below, std::max(std::abs(above), std::abs(below)));
    const bool force = observables_[i].is_force();
    if (!observables_[i].is_linear())
      continue;
    const bool sound =
        force || (known.is_of_motion(largest, range) && known.is_of_motion(smallest, range));
    const double high = known.of(largest), low = force ? nan : 0 - known.of(smallest);
    const auto add = [&](const Label &label, double derivative) {
      if (!sound || std::isfinite(derivative))
        result.number(label, sound ? derivative : nan);
    };
    add(labels_[i].maximum, high);
    add(labels_[i].minimum, low);
    add(labels_[i].peak_to_peak, high - low);
    add(labels_[i].amplitude, (high - low) / 2);
    add(labels_[i].largest, above >= below ? high : 0 - low);
  }
}

} // namespace vibroimpact::analyses
