// Spectra of the recorded window: amplitudes over frequency from equally spaced samples, and the
// amplitudes of the orders of the forcing frequency from exact Fourier integrals.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/recorders/sampler.h"
#include "analyses/results/field_writer.h"
#include "analyses/signals/order_integrals.h"

#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct SpectrumSettings {
  long samples_per_cycle = 256; ///< without periods: samples of the window
  long orders = 10;
  double highest_order = 0; ///< lines beyond it are left out; 0: none is
  std::string window = "none";
};

class SpectrumRecorder : public Recorder {
public:
  SpectrumRecorder(std::vector<Observable> signals, SpectrumSettings settings)
      : signals_(std::move(signals)), settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  void add_fields(const FieldWriter &result) const override;

private:
  void add_orders(const FieldWriter &result) const;
  void add_lines(const FieldWriter &result) const;
  double line_spacing() const;

  std::vector<Observable> signals_;
  SpectrumSettings settings_;
  double period_ = 0;
  std::size_t count_ = 0;
  double interval_ = 0; ///< of the samples [s]
  Sampler samples_;
  std::optional<OrderIntegrals> orders_; ///< only with periods
};

} // namespace vibroimpact::analyses
