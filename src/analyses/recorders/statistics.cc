#include "analyses/recorders/statistics.h"

#include "analyses/recorders/step_quadrature.h"
#include "analyses/results/fields.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

namespace {
constexpr const char *statistics_section = "Statistics";
} // namespace

void TimeAverage::add(const StepFunction &function, double length) {
  for (const QuadratureNode &node : step_nodes())
    add(function(node.tau), node.weight * length);
}

double TimeAverage::mean_square() const {
  return boost::accumulators::weighted_variance(moments_) + mean() * mean();
}

double TimeAverage::rms() const { return std::sqrt(mean_square()); }

double TimeAverage::rms_about_mean() const {
  return std::sqrt(boost::accumulators::weighted_variance(moments_));
}

AverageLabels::AverageLabels(const std::string &path, const std::string &unit)
    : mean(path + "/mean", unit, "mean over the recorded window"),
      rms(path + "/rms", unit, "root mean square over the window"),
      rms_about_mean(path + "/rms_about_mean", unit,
                     "root mean square of the difference from the mean") {}

void add_average(const FieldWriter &result, const AverageLabels &labels,
                 const TimeAverage &average) {
  result.number(labels.mean, average.mean());
  result.number(labels.rms, average.rms());
  result.number(labels.rms_about_mean, average.rms_about_mean());
}

Statistics::Statistics(const ObservedSelection &selection, const System &system)
    : observables_(observables(selection, system)), averages_(observables_.size()) {
  put_forces_last(observables_);
  for (const Observable &observed : observables_)
    labels_.emplace_back(observed.path, observed.unit);
}

void Statistics::declare(parameters::Section &analysis) {
  declare_selection_of_quantities(
      analysis.subsection(statistics_section, "The recorder of means and root mean squares."));
}

RecorderFactory Statistics::create(const parameters::Values &analysis) {
  const parameters::Values section = analysis.subsection(statistics_section);
  const ObservedSelection selection = read_selection_of_quantities(section);
  return [section, selection](const System &system) {
    check_points(selection, system, section);
    return std::make_unique<Statistics>(selection, system);
  };
}

void Statistics::begin(const Window & /*window*/, const motion::Trajectory & /*trajectory*/) {
  std::fill(averages_.begin(), averages_.end(), TimeAverage{});
}

void Statistics::step(const motion::StepView &view) {
  for (std::size_t i = 0; i < observables_.size(); ++i)
    averages_[i].add(along(observables_[i], view), view.length());
}

void Statistics::add_fields(const FieldWriter &result) const {
  for (std::size_t i = 0; i < observables_.size(); ++i)
    add_average(result, labels_[i], averages_[i]);
}

} // namespace vibroimpact::analyses
