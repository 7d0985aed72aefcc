// Is the variation of a random motion, by its state and by keys, what differences of the motion
// say?
#pragma once

#include <cstdint>
#include <set>
#include <string>

namespace vibroimpact::testing {

/// Verdicts:
///   agree        to 1e-7 of each column, or to ten times what the differences leave open where
///                that is more than 1e-8
///   unresolved   the differences leave more than 1e-4 open, or no small step keeps the sequence of
///                events: a grazing contact is near
///   no derivative  several contacts at one instant; the variation has counted it
///   failed       the motion has no end, by a reason; refused: not a model
///   wrong
struct VariationVerdict {
  std::string word;
  std::string detail{};
  double by_state = 0;    ///< largest difference of a column, relative to it
  double by_key = 0;      ///< the same of keys
  double determinant = 0; ///< difference of logarithms; NaN where it is not compared
  double open = 0;        ///< what the differences leave open, at most
  double cost = 0;        ///< processor time with variation over that without
  int events = 0;
  int columns = 0, keys = 0;     ///< that were compared
  std::set<std::string> laws{};  ///< of contacts that had events
  std::set<std::string> kinds{}; ///< of events
};

VariationVerdict judge_variation(std::uint64_t seed, const std::string &folder);

} // namespace vibroimpact::testing
