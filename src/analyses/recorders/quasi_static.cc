#include "analyses/recorders/quasi_static.h"

#include "analyses/results/fields.h"
#include "common/zero.h"
#include "motion/system/equilibrium.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::analyses {

namespace {

// Loads that vary in time, frozen at an instant.
Vector varying_load(const model::Model &model, double time) {
  Vector load = Vector::Zero(model.size());
  for (const model::Source &source : model.sources()) {
    if (source.function->highest_frequency() == 0)
      continue;
    if (!source.load.isZero(0))
      load += source.function->value(time) * source.load;
    if (!source.inertial_load.isZero(0))
      load += source.function->acceleration(time) * source.inertial_load;
  }
  return load;
}

} // namespace

QuasiStatic::QuasiStatic(const System &system) : system_(system) {}

void QuasiStatic::declare(parameters::Section & /*analysis*/) {}

RecorderFactory QuasiStatic::create(const parameters::Values & /*analysis*/) {
  return [](const System &system) { return std::make_unique<QuasiStatic>(system); };
}

double QuasiStatic::size(double time) const {
  const Vector load = varying_load(system_.model, time);
  return load.cwiseAbs2().cwiseQuotient(system_.model.mass()).sum();
}

void QuasiStatic::consider(double time) {
  const double found = size(time);
  if (found > peak_size_) {
    peak_size_ = found;
    peak_time_ = time;
  }
}

void QuasiStatic::begin(const Window &window, const motion::Trajectory & /*trajectory*/) {
  window_ = window;
  peak_time_ = longest_step_ = 0;
  peak_size_ = -1;
  displacements_.clear();
  consider(window.start);
}

void QuasiStatic::step(const motion::StepView &view) {
  longest_step_ = std::max(longest_step_, view.length());
  consider((view.start() + view.end()) / 2);
  consider(view.equations().source_time(view.end()));
}

void QuasiStatic::end(const motion::Trajectory & /*trajectory*/) {
  const double lower = std::max(window_.start, peak_time_ - longest_step_);
  const double upper = std::min(window_.end, peak_time_ + longest_step_);
  consider(minimum_between([this](double time) { return -size(time); }, lower, upper).place);
  const Vector load = varying_load(system_.model, peak_time_);
  for (const double sign : {1.0, -1.0})
    displacements_.push_back(motion::static_equilibrium(system_.model, system_.contacts,
                                                        system_.model.static_load() + sign * load)
                                 .displacement);
}

void QuasiStatic::add_fields(const FieldWriter &result) const {
  for (const Channel &channel : observed_channels(system_.model)) {
    const std::string path =
        "point/" + channel.point + "/quasi_static_displacement_" + channel.axis;
    std::vector<double> values;
    for (const Vector &q : displacements_)
      values.push_back(channel.relative.row.dot(q));
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    if (values.empty())
      continue;
    result.number(path + "/minimum", *lowest, "m",
                  "static displacement under the peak of the excitation of "
                  "either sign, smaller one");
    result.number(path + "/maximum", *highest, "m",
                  "static displacement under the peak of the excitation of "
                  "either sign, larger one");
  }
}

} // namespace vibroimpact::analyses
