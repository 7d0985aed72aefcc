#include "analyses/recorders/statistics.h"

#include "analyses/fields.h"
#include "analyses/recorders/step_quadrature.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

namespace {
constexpr const char *statistics_section = "Statistics";
} // namespace

void TimeAverage::add(const motion::Bernstein &curve, double length) {
  for (const QuadratureNode &node : step_nodes())
    add(curve(node.tau), node.weight * length);
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
    : contacts_(system.contacts), quantities_(observed_quantities(selection, system)),
      averages_(quantities_.size()) {
  for (const ObservedQuantity &quantity : quantities_)
    labels_.emplace_back(quantity.path, quantity.unit);
  if (!selection.has("normal_force"))
    return;
  for (const contact::ContactPair &pair : contacts_.pairs())
    labels_.emplace_back("contact/" + pair.name + "/normal_force", "N");
  forces_.resize(contacts_.size());
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
  std::fill(forces_.begin(), forces_.end(), TimeAverage{});
}

void Statistics::step(const motion::StepView &view) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    averages_[i].add(quantities_[i].curve(view), view.length());
  for (std::size_t c = 0; c < forces_.size(); ++c) {
    const bool touching = in_contact(view, c);
    const motion::ContactCurves curves =
        touching ? view.contact_curves(c) : motion::ContactCurves{};
    for (const QuadratureNode &node : step_nodes())
      forces_[c].add(touching ? view.force(c, curves, node.tau) : 0, node.weight * view.length());
  }
}

void Statistics::add_fields(const FieldWriter &result) const {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    add_average(result, labels_[i], averages_[i]);
  for (std::size_t c = 0; c < forces_.size(); ++c)
    add_average(result, labels_[quantities_.size() + c], forces_[c]);
}

} // namespace vibroimpact::analyses
