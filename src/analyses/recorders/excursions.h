// Extreme values of a motion over a window, from the dense output.
#pragma once

#include "analyses/recorder.h"
#include "analyses/recorders/watched_quantities.h"
#include "integration/extent.h"

#include <vector>

namespace vibroimpact::analyses {

/// PATH/peak_to_peak_excursion, /peak_excursion, /minimum, /maximum of a quantity.
struct ExtentLabels {
  explicit ExtentLabels(const WatchedQuantity &quantity);
  Label peak_to_peak, peak, minimum, maximum;
};

/// All four as scalar fields.
void add_extent(PointResult &result, const ExtentLabels &labels, const integration::Extent &extent);

class Excursions : public Recorder, private integration::FlightWatcher {
public:
  Excursions(const WatchedSelection &selection, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const integration::Trajectory &trajectory) override;
  void step(const integration::StepView &view) override;
  /// None where something that is watched is not linear in the motion.
  integration::FlightWatcher *flight_watcher() override { return linear_ ? this : nullptr; }
  /// Extreme values of every quantity watched; of gaps only minimum and maximum, of contact forces
  /// only the maximum.
  void add_fields(PointResult &result) const override;

private:
  void watch(const integration::Equations &equations,
             std::vector<integration::WatchedForm> &forms) override;

  const contact::ContactSet &contacts_;
  std::vector<WatchedQuantity> quantities_;
  std::vector<ExtentLabels> labels_;
  std::vector<integration::Extent> extents_;
  std::vector<Label> force_labels_;         ///< per contact; empty when not watched
  std::vector<integration::Extent> forces_; ///< the same
  bool linear_ = true;
};

} // namespace vibroimpact::analyses
