#include "analyses/recorders/history.h"

#include "analyses/fields.h"
#include "analyses/motion_recorder.h"
#include "analyses/recorders/force_quantities.h"
#include "common/error.h"
#include "common/memory.h"

namespace vibroimpact::analyses {

namespace {
constexpr const char *history_section = "History";
constexpr const char *dimension = "history_time";
constexpr double most_samples = 1e8;
} // namespace

History::History(Settings settings, const System &system)
    : settings_(std::move(settings)), contacts_(system.contacts),
      quantities_(observed_quantities(settings_.selection, system)),
      forces_observed_(settings_.selection.has("normal_force")) {
  if (settings_.selection.has("connection_force"))
    for (ObservedQuantity &force : connection_forces(system.model))
      quantities_.push_back(std::move(force));
  values_.resize(quantities_.size());
  forces_.resize(forces_observed_ ? contacts_.size() : 0);
}

void History::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(history_section, "The recorder of time histories.");
  declare_selection_of_quantities(section);
  section
      .integer("Samples per period", "200", Range{.lower = 2, .upper = 1e6}, "",
               "Samples in each period of the excitation.")
      .quantity("Sampling interval", "", dimension::time, range::positive, "dt",
                "Interval of the samples; empty means by the samples per period, or a thousandth "
                "of a window that is not divided into periods.");
}

RecorderFactory History::create(const parameters::Values &analysis) {
  const parameters::Values section = analysis.subsection(history_section);
  const Settings settings{
      .selection = read_selection_of_quantities(section),
      .samples_per_period = section.integer("Samples per period"),
      .interval = section.has("Sampling interval") ? section.quantity("Sampling interval") : 0};
  return [section, settings](const System &system) {
    check_points(settings.selection, system, section);
    return std::make_unique<History>(settings, system);
  };
}

void History::begin(const Window &window, const motion::Trajectory & /*trajectory*/) {
  double interval = settings_.interval;
  if (interval == 0)
    interval = window.cycles > 0 ? window.period / static_cast<double>(settings_.samples_per_period)
                                 : window.length() / 1000;
  if (window.length() / interval > most_samples)
    throw NumericalError("the recorded history would have more than 1e8 samples");
  const auto series = static_cast<double>(values_.size() + forces_.size());
  if (const std::string lack = lack_of_memory(24 * series * window.length() / interval);
      !lack.empty())
    throw NumericalError("for the recorded history " + lack);
  instants_ = equal_instants(window.start, window.end, interval);
  next_ = 0;
  for (auto *series : {&values_, &forces_})
    for (std::vector<double> &values : *series)
      values.clear();
}

void History::step(const motion::StepView &view) {
  const std::size_t first = next_;
  while (next_ < instants_.size() && instants_[next_] <= view.end())
    ++next_;
  if (next_ == first)
    return;
  const auto tau = [&](std::size_t i) { return (instants_[i] - view.start()) / view.length(); };
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const motion::Bernstein curve = quantities_[k].curve(view);
    for (std::size_t i = first; i < next_; ++i)
      values_[k].push_back(curve(tau(i)));
  }
  for (std::size_t c = 0; c < forces_.size(); ++c)
    for (std::size_t i = first; i < next_; ++i)
      forces_[c].push_back(in_contact(view, c) ? view.force(c, tau(i)) : 0);
}

void History::add_fields(const FieldWriter &result) const {
  const FieldWriter of = result.below("history/");
  const std::vector<double> taken(instants_.begin(),
                                  instants_.begin() + static_cast<std::ptrdiff_t>(next_));
  of.series(dimension, dimension, taken, "s", "time");
  for (std::size_t k = 0; k < quantities_.size(); ++k)
    of.series(quantities_[k].path, dimension, values_[k], quantities_[k].unit,
              quantities_[k].meaning);
  for (std::size_t c = 0; c < forces_.size(); ++c)
    of.series("contact/" + contacts_.pairs()[c].name + "/normal_force", dimension, forces_[c], "N",
              "normal force, > 0 pushes apart");
}

} // namespace vibroimpact::analyses
