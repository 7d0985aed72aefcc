#include "analyses/recorders/statistics.h"

#include "analyses/fields.h"
#include "analyses/recorders/step_quadrature.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact {

namespace {
constexpr const char *section_name = "Statistics";
} // namespace

void TimeAverage::add(const Bernstein &curve, double length) {
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

void add_average(PointResult &result, const std::string &path, const std::string &unit,
                 const TimeAverage &average) {
  result.fields.push_back(
      scalar_field(path + "/mean", average.mean(), unit, "mean over the recorded window"));
  result.fields.push_back(
      scalar_field(path + "/rms", average.rms(), unit, "root mean square over the window"));
  result.fields.push_back(scalar_field(path + "/rms_about_mean", average.rms_about_mean(), unit,
                                       "root mean square of the difference from the mean"));
}

Statistics::Statistics(const WatchedSelection &selection, const System &system)
    : contacts_(system.contacts), quantities_(watched_quantities(selection, system)),
      averages_(quantities_.size()) {
  if (selection.has("normal_force"))
    forces_.resize(contacts_.size());
}

void Statistics::declare(parameters::Section &analysis) {
  declare_selection_of_quantities(
      analysis.subsection(section_name, "The recorder of means and root mean squares."));
}

RecorderFactory Statistics::create(const parameters::Values &analysis) {
  const parameters::Values section = analysis.subsection(section_name);
  const WatchedSelection selection = read_selection_of_quantities(section);
  return [section, selection](const System &system) {
    check_points(selection, system, section);
    return std::make_unique<Statistics>(selection, system);
  };
}

void Statistics::step(const StepView &view) {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    averages_[i].add(quantities_[i].curve(view), view.length());
  for (std::size_t c = 0; c < forces_.size(); ++c) {
    const bool touching = in_contact(view, c);
    const ContactCurves curves = touching ? view.contact_curves(c) : ContactCurves{};
    for (const QuadratureNode &node : step_nodes())
      forces_[c].add(touching ? view.force(c, curves, node.tau) : 0, node.weight * view.length());
  }
}

void Statistics::add_fields(PointResult &result) const {
  for (std::size_t i = 0; i < quantities_.size(); ++i)
    add_average(result, quantities_[i].path, quantities_[i].unit, averages_[i]);
  for (std::size_t c = 0; c < forces_.size(); ++c)
    add_average(result, "contact/" + contacts_.pairs()[c].name + "/normal_force", "N", forces_[c]);
}

} // namespace vibroimpact
