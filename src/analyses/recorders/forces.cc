#include "analyses/recorders/forces.h"

#include "analyses/recorders/channels.h"
#include "analyses/recorders/force_quantities.h"
#include "analyses/results/fields.h"

#include <limits>

namespace vibroimpact::analyses {

using model::Model;
using model::Projection;
using motion::StepView;

namespace {

// The motion of the base alone.
Projection base_of(Projection absolute) {
  absolute.row.setZero();
  return absolute;
}

// The time history of a source alone.
Projection history_of(std::size_t source, const Model &model) {
  Projection history{.row = RowVector::Zero(model.size()), .base_coefficients = {}};
  history.base_coefficients.assign(model.sources().size(), 0);
  history.base_coefficients[source] = 1;
  return history;
}

// Index of the only force that varies in time, or the number of sources.
std::size_t single_force(const Model &model) {
  const std::size_t none = model.sources().size();
  std::size_t found = none;
  for (std::size_t k = 0; k < none; ++k) {
    const model::Source &source = model.sources()[k];
    if (source.function->highest_frequency() == 0)
      continue;
    if (source.load.isZero(0) || !source.inertial_load.isZero(0) || found != none)
      return none;
    found = k;
  }
  return found;
}

Label ratio_label(const std::string &path, const std::string &meaning) {
  return {path + "/transmissibility", "1", meaning + ", amplitudes"};
}

} // namespace

Forces::ObservedForce::ObservedForce(Observable observed)
    : quantity(std::move(observed)), range_labels(quantity),
      average_labels(quantity.path, quantity.unit) {}

Forces::Forces(const System &system) {
  for (Observable &quantity : connection_forces(system.model))
    forces_.emplace_back(std::move(quantity));
  for (Observable &quantity : base_forces(system.model))
    forces_.emplace_back(std::move(quantity));
  add_ratios_of_points(system.model);
  add_ratios_of_forces(system.model);
}

void Forces::add_ratios_of_points(const Model &model) {
  for (const Channel &channel : observed_channels(model)) {
    if (!channel.carried())
      continue;
    const std::string base = "point/" + channel.point + "/";
    const Projection whole = channel.absolute;
    const Projection base_coefficients = base_of(channel.absolute);
    ratios_.push_back(
        {.label = ratio_label(base + "displacement_" + channel.axis,
                              "absolute displacement over that of the base"),
         .output = [whole](const StepView &v) { return v.displacement(whole); },
         .input =
             [base_coefficients](const StepView &v) { return v.displacement(base_coefficients); }});
    ratios_.push_back(
        {.label = ratio_label(base + "acceleration_" + channel.axis,
                              "absolute acceleration over that of the base"),
         .output = [whole](const StepView &v) { return v.acceleration(whole); },
         .input =
             [base_coefficients](const StepView &v) { return v.acceleration(base_coefficients); }});
  }
}

void Forces::add_ratios_of_forces(const Model &model) {
  const std::size_t source = single_force(model);
  if (source == model.sources().size())
    return;
  const Projection applied = history_of(source, model);
  for (Observable &force : base_forces(model))
    ratios_.push_back({.label = ratio_label(force.path, "force on the base over the applied force"),
                       .output = std::get<motion::CurveForm>(force.form),
                       .input = [applied](const StepView &v) { return v.displacement(applied); }});
}

void Forces::declare(parameters::Section & /*analysis*/) {}

RecorderFactory Forces::create(const parameters::Values & /*analysis*/) {
  return [](const System &system) { return std::make_unique<Forces>(system); };
}

void Forces::begin(const Window & /*window*/, const motion::Trajectory & /*trajectory*/) {
  for (ObservedForce &force : forces_) {
    force.range = {};
    force.average = {};
  }
  for (Ratio &ratio : ratios_)
    ratio.output_range = ratio.input_range = {};
}

void Forces::step(const StepView &view) {
  for (ObservedForce &force : forces_) {
    const motion::Bernstein along_step = curve(force.quantity.form, view);
    force.range.include(along_step);
    force.average.add(along_step, view.length());
  }
  for (Ratio &ratio : ratios_) {
    ratio.output_range.include(ratio.output(view));
    ratio.input_range.include(ratio.input(view));
  }
}

void Forces::add_fields(const FieldWriter &result) const {
  for (const ObservedForce &force : forces_) {
    add_range(result, force.range_labels, force.range);
    add_average(result, force.average_labels, force.average);
  }
  for (const Ratio &ratio : ratios_) {
    const double input = ratio.input_range.peak_to_peak();
    result.number(ratio.label, input > 0 ? ratio.output_range.peak_to_peak() / input
                                         : std::numeric_limits<double>::quiet_NaN());
  }
}

} // namespace vibroimpact::analyses
