// Forces that are passed on in a window, and how much of the excitation they pass on.
//
// Amplitudes are half the peak-to-peak values. Transmissibility is the ratio of the absolute
// displacement or acceleration of a point to that of its base where a base moves, and of the force
// on the base to the applied force where a single force varies in time.
#pragma once

#include "analyses/recorders/extreme_values.h"
#include "analyses/recorders/statistics.h"
#include "analyses/results/field_writer.h"

namespace vibroimpact::analyses {

class Forces : public Recorder {
public:
  explicit Forces(const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void step(const motion::StepView &view) override;
  /// Extreme values, mean and root mean squares of connection/NAME/force and
  /// body/NAME/base_force_x; transmissibility below point/BODY.POINT/displacement_x and
  /// /acceleration_x, and below body/NAME/base_force_x.
  void add_fields(const FieldWriter &result) const override;

private:
  struct ObservedForce {
    explicit ObservedForce(Observable observed);
    Observable quantity;
    ExtremeValueLabels range_labels;
    AverageLabels average_labels;
    motion::ValueRange range{};
    TimeAverage average{};
  };
  /// One amplitude over another.
  struct Ratio {
    Label label;
    std::function<motion::Bernstein(const motion::StepView &view)> output, input;
    motion::ValueRange output_range{}, input_range{};
  };
  void add_ratios_of_points(const model::Model &model);
  void add_ratios_of_forces(const model::Model &model);

  std::vector<ObservedForce> forces_;
  std::vector<Ratio> ratios_;
};

} // namespace vibroimpact::analyses
