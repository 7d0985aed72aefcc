// Extreme values of a motion over a window, from the dense output.
#pragma once

#include "analyses/recorders/observables.h"
#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"
#include "motion/interval/value_range.h"

#include <vector>

namespace vibroimpact::analyses {

/// PATH/peak_to_peak, /amplitude (half of it), /largest (of the absolute value), /minimum, /maximum
/// of a quantity.
struct ExtremeValueLabels {
  explicit ExtremeValueLabels(const Observable &observed);
  Label peak_to_peak, amplitude, largest, minimum, maximum;
};

/// All five as scalar fields.
void add_range(const FieldWriter &result, const ExtremeValueLabels &labels,
               const motion::ValueRange &range);

class ExtremeValues : public Recorder {
public:
  ExtremeValues(const ObservedSelection &selection, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void outputs(const motion::Equations &equations, std::vector<motion::Output> &list) override;
  /// Where something that is observed is not linear in the motion, or extrema are kept.
  bool sees_steps(const motion::Equations & /*equations*/) const override {
    return !linear_ || !extrema_.empty();
  }
  void step(const motion::StepView &view) override;
  /// Extreme values of every quantity observed; of gaps only minimum and maximum, of contact forces
  /// only the maximum. Internal states that belong to an impact are NaN without one.
  void add_fields(const FieldWriter &result) const override;
  bool keeps_extrema() override;
  std::vector<ObservedExtremum> extrema() const override;
  void add_tangents(const TangentMotion &motion, const FieldWriter &result) const override;

private:
  /// Of one quantity.
  struct Extrema {
    motion::Extremum largest, smallest; ///< the smallest one of the reversed sign
  };
  void include(Extrema &extrema, const Observable &observed, const motion::StepView &view) const;

  std::vector<Observable> observables_;
  std::vector<ExtremeValueLabels> labels_;
  std::vector<motion::ValueRange> ranges_;
  std::vector<Extrema> extrema_; ///< of each quantity, where they are kept
  bool linear_ = true;
};

} // namespace vibroimpact::analyses
