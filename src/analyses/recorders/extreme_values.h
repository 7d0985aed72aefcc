// Extreme values of a motion over a window, from the dense output.
#pragma once

#include "analyses/field_writer.h"
#include "analyses/recorder.h"
#include "analyses/recorders/observed_quantities.h"
#include "motion/segment/value_range.h"

#include <vector>

namespace vibroimpact::analyses {

/// PATH/peak_to_peak, /amplitude (half of it), /largest (of the absolute value), /minimum, /maximum
/// of a quantity.
struct ExtremeValueLabels {
  explicit ExtremeValueLabels(const ObservedQuantity &quantity);
  Label peak_to_peak, amplitude, largest, minimum, maximum;
};

/// All five as scalar fields.
void add_range(const FieldWriter &result, const ExtremeValueLabels &labels,
               const motion::ValueRange &range);

class ExtremeValues : public Recorder, private motion::OutputMonitor {
public:
  ExtremeValues(const ObservedSelection &selection, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  /// None where something that is observed is not linear in the motion.
  motion::OutputMonitor *output_monitor() override { return linear_ ? this : nullptr; }
  /// Extreme values of every quantity observed; of gaps only minimum and maximum, of contact forces
  /// only the maximum.
  void add_fields(const FieldWriter &result) const override;

private:
  void add_forms(const motion::Equations &equations,
                 std::vector<motion::MonitoredForm> &forms) override;

  const contact::ContactSet &contacts_;
  std::vector<ObservedQuantity> quantities_;
  std::vector<ExtremeValueLabels> labels_;
  std::vector<motion::ValueRange> ranges_;
  std::vector<Label> force_labels_;        ///< per contact; empty when not observed
  std::vector<motion::ValueRange> forces_; ///< the same
  bool linear_ = true;
};

} // namespace vibroimpact::analyses
