// Smallest and largest value seen of something.
#pragma once

#include "motion/interval/bernstein.h"

#include <limits>

namespace vibroimpact::motion {

struct ValueRange {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();

  void include(const Bernstein &polynomial);
  void include(double value);
  /// maximum - minimum; NaN when nothing was seen.
  double peak_to_peak() const;
  /// Largest absolute value; NaN when nothing was seen.
  double peak() const;
};

} // namespace vibroimpact::motion
