// Is the variation of a random motion, by its state and by keys, what differences of the motion
// say?
#pragma once

#include "random_models/spectra.h"

#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>

namespace vibroimpact::testing {

/// A column of the variation, by a coordinate or a key, beside differences.
struct Found {
  double apart =
      std::numeric_limits<double>::quiet_NaN(); ///< relative to the column; NaN: unresolved
  double open = 0;                              ///< what the differences leave open
};

/// Verdicts:
///   agree        every column to 1e-7, in the first of eight windows of the motion in which
///                differences resolve it
///   agree but for rounding   in no window to more than the differences leave open, times ten; less
///                than 1e-5
///   unresolved   some in none of them
///   no derivative  in no window: several contacts at one instant; the variation has counted it
///   failed       the motion has no end, by a reason; refused: not a model
///   wrong        also where the motion has an end but its variation has none
struct VariationVerdict {
  std::string word;
  std::string detail{};
  std::map<std::string, Found> found{}; ///< of each column
  /// Difference of logarithms; NaN where it is not compared.
  double determinant = std::numeric_limits<double>::quiet_NaN();
  double cost = 0;               ///< processor time with variation over that without
  int window = 0;                ///< the last one that was needed
  int events = 0;                ///< of all windows
  SpectraVerdict multipliers{};  ///< of the matrix of a window
  std::set<std::string> laws{};  ///< of contacts that had events
  std::set<std::string> kinds{}; ///< of events

  double largest() const; ///< of `found` that are resolved
};

VariationVerdict judge_variation(std::uint64_t seed, const std::string &folder);

} // namespace vibroimpact::testing
