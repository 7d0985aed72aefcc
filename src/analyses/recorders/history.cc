#include "analyses/recorders/history.h"

#include "analyses/recorders/force_quantities.h"
#include "common/error.h"
#include "common/memory.h"

namespace vibroimpact::analyses {

namespace {
constexpr const char *history_section = "History";
constexpr double most_samples = 1e8;
const std::vector<std::string> more_kinds = {"connection_force"};
} // namespace

History::History(Settings settings, const System &system)
    : settings_(std::move(settings)), observables_(observables(settings_.selection, system)) {
  if (settings_.selection.has(more_kinds.front()))
    for (Observable &force : connection_forces(system.model))
      observables_.push_back(std::move(force));
  put_forces_last(observables_);
}

void History::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(history_section, "The recorder of time histories.");
  declare_selection_of_quantities(section, more_kinds);
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
      .selection = read_selection_of_quantities(section, more_kinds),
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
  const auto series = static_cast<double>(observables_.size());
  if (const std::string lack = lack_of_memory(24 * series * window.length() / interval);
      !lack.empty())
    throw NumericalError("for the recorded history " + lack);
  sampler_ = Sampler(observables_, equal_instants(window.start, window.end, interval));
}

void History::add_fields(const FieldWriter &result) const {
  sampler_.add_fields(result.below("history/"), "history_time");
}

} // namespace vibroimpact::analyses
