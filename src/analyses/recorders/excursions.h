// Extreme values of a motion over a window, from the dense output.
#pragma once

#include "analyses/recorder.h"
#include "analyses/recorders/watched_quantities.h"

#include <limits>
#include <vector>

namespace vibroimpact {

/// Smallest and largest value seen.
struct Extent {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();

  void include(const Bernstein &polynomial);
  void include(double value);
  /// maximum - minimum; NaN when nothing was seen.
  double peak_to_peak() const;
  /// Largest absolute value; NaN when nothing was seen.
  double peak() const;
};

/// PATH/peak_to_peak_excursion, /peak_excursion, /minimum, /maximum of a quantity.
struct ExtentLabels {
  explicit ExtentLabels(const WatchedQuantity &quantity);
  Label peak_to_peak, peak, minimum, maximum;
};

/// All four as scalar fields.
void add_extent(PointResult &result, const ExtentLabels &labels, const Extent &extent);

class Excursions : public Recorder {
public:
  Excursions(const WatchedSelection &selection, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const Trajectory &trajectory) override;
  void step(const StepView &view) override;
  /// Extreme values of every quantity watched; of gaps only minimum and maximum, of contact forces
  /// only the maximum.
  void add_fields(PointResult &result) const override;

private:
  const ContactSet &contacts_;
  std::vector<WatchedQuantity> quantities_;
  std::vector<ExtentLabels> labels_;
  std::vector<Extent> extents_;
  std::vector<Label> force_labels_;   ///< per contact; empty when not watched
  std::vector<double> largest_force_; ///< the same
};

} // namespace vibroimpact
