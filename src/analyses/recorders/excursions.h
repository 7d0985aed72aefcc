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

/// PATH/peak_to_peak_excursion, /peak_excursion, /minimum, /maximum of a quantity as scalar fields.
void add_extent(PointResult &result, const WatchedQuantity &quantity, const Extent &extent);

class Excursions : public Recorder {
public:
  Excursions(const WatchedSelection &selection, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void step(const StepView &view) override;
  /// Extreme values of every quantity watched; of gaps only minimum and maximum, of contact forces
  /// only the maximum.
  void add_fields(PointResult &result) const override;

private:
  const ContactSet &contacts_;
  std::vector<WatchedQuantity> quantities_;
  std::vector<Extent> extents_;
  std::vector<double> largest_force_; ///< per contact; empty when not watched
};

} // namespace vibroimpact
