// Time histories of what a recorder can watch, sampled in the window.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/recorders/sampler.h"
#include "analyses/results/field_writer.h"

#include <vector>

namespace vibroimpact::analyses {

class History : public Recorder {
public:
  struct Settings {
    ObservedSelection selection;
    long samples_per_period = 0;
    double interval = 0; ///< [s]; 0: by the samples per period, or a thousandth of the window
  };
  History(Settings settings, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  /// NumericalError when the window is too long for the interval.
  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override { sampler_.step(view); }
  /// history/PATH along history_time for every quantity; a sample at a contact change is that
  /// before it.
  void add_fields(const FieldWriter &result) const override;

private:
  Settings settings_;
  std::vector<Observable> observables_;
  Sampler sampler_;
};

} // namespace vibroimpact::analyses
