#include "analyses/recorders/spectrum.h"

#include "analyses/results/fields.h"
#include "common/fourier.h"

#include <algorithm>
#include <numbers>

namespace vibroimpact::analyses {

namespace {
constexpr const char *spectrum_section = "Spectrum";
} // namespace

void SpectrumRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(spectrum_section,
                                         "Amplitude spectra of the recorded window, and amplitudes "
                                         "and phases of the orders of the forcing frequency.");
  declare_signals(section);
  section
      .integer("Samples per cycle", "256", Range{.lower = 4, .upper = 1e7}, "",
               "Samples in a forcing period; in a window without periods, in all of it.")
      .choice("Window", "none", {"none", "hann"},
              "Weights of the samples: none for whole periods, hann for other windows.")
      .integer("Orders", "10", Range{.lower = 1, .upper = 1000}, "",
               "Orders of the forcing frequency whose amplitude and phase are integrated.")
      .quantity("Highest order", "20", dimension::none, range::positive, "",
                "Lines of the spectrum above this multiple of the forcing frequency are left out.");
}

RecorderFactory SpectrumRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(spectrum_section);
  const SpectrumSettings settings{.samples_per_cycle = values.integer("Samples per cycle"),
                                  .orders = values.integer("Orders"),
                                  .highest_order = values.quantity("Highest order"),
                                  .window = values.choice("Window")};
  return [settings, values](const System &system) -> std::unique_ptr<Recorder> {
    return std::make_unique<SpectrumRecorder>(chosen_signals(values, system), settings);
  };
}

void SpectrumRecorder::begin(const Window &window, const motion::Trajectory & /*trajectory*/) {
  period_ = window.cycles > 0 ? window.period : 0;
  count_ = static_cast<std::size_t>(std::max(window.cycles, 1L) * settings_.samples_per_cycle);
  interval_ = (window.end - window.start) / static_cast<double>(count_);
  samples_ = Sampler(signals_, window.start, interval_, count_);
  orders_.reset();
  if (period_ > 0)
    orders_.emplace(window.start, 2 * std::numbers::pi / period_,
                    static_cast<std::size_t>(settings_.orders), signals_.size());
}

void SpectrumRecorder::step(const motion::StepView &view) {
  samples_.step(view);
  if (!orders_)
    return;
  std::vector<StepFunction> functions;
  for (const Observable &signal : signals_)
    functions.push_back(along(signal, view));
  orders_->add(view.start(), view.length(), functions);
}

double SpectrumRecorder::line_spacing() const {
  return 1 / (static_cast<double>(count_) * interval_);
}

void SpectrumRecorder::add_orders(const FieldWriter &result) const {
  std::vector<double> orders;
  for (long j = 1; j <= settings_.orders; ++j)
    orders.push_back(static_cast<double>(j));
  result.series("order", "order", orders, "1", "multiple of the forcing frequency");
  for (std::size_t s = 0; s < signals_.size(); ++s) {
    const Observable &signal = signals_[s];
    std::vector<double> amplitude, phase;
    for (long j = 1; j <= settings_.orders; ++j) {
      amplitude.push_back(orders_->amplitude(s, static_cast<std::size_t>(j)));
      phase.push_back(orders_->phase(s, static_cast<std::size_t>(j)));
    }
    result.series("order_amplitude/" + signal.path, "order", amplitude, signal.unit,
                  "amplitude of an order of the " + signal.description());
    result.series("order_phase/" + signal.path, "order", phase, "rad",
                  "phase of the cosine of an order at forcing phase zero");
    result.number("mean/" + signal.path, orders_->mean(s), signal.unit,
                  "mean of the " + signal.description());
  }
}

void SpectrumRecorder::add_lines(const FieldWriter &result) const {
  const std::vector<double> weights = taper(settings_.window, count_);
  std::vector<double> frequency;
  for (std::size_t j = 0; j <= count_ / 2; ++j)
    frequency.push_back(static_cast<double>(j) * line_spacing());
  if (period_ > 0)
    std::erase_if(frequency,
                  [&](double f) { return f * period_ > settings_.highest_order + 1e-9; });
  const auto lines = static_cast<std::ptrdiff_t>(frequency.size());
  std::vector<double> order;
  for (std::size_t j = 0; period_ > 0 && j < frequency.size(); ++j)
    order.push_back(frequency[j] * period_);
  result.series("spectrum/frequency", "spectrum_frequency", frequency, "Hz", "frequency of a line");
  if (period_ > 0)
    result.series("spectrum/order", "spectrum_frequency", order, "1",
                  "frequency of a line over forcing frequency");
  for (std::size_t s = 0; s < signals_.size(); ++s) {
    if (samples_.values(s).size() != count_)
      continue; // the motion ended early
    const std::vector<double> amplitudes = amplitude_spectrum(samples_.values(s), weights);
    result.series("spectrum/" + signals_[s].path, "spectrum_frequency",
                  {amplitudes.begin(), amplitudes.begin() + lines}, signals_[s].unit,
                  "amplitude of the " + signals_[s].description());
  }
}

void SpectrumRecorder::add_fields(const FieldWriter &result) const {
  if (orders_)
    add_orders(result);
  add_lines(result);
}

} // namespace vibroimpact::analyses
