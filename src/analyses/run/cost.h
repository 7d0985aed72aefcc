// What a run will cost, estimated before it starts from points that are tried.
#pragma once

#include "analyses/run/runner.h"

#include <string>

namespace vibroimpact::analyses {

/// Of one analysis, in seconds of computing on one core.
struct Cost {
  double seconds = 0;
  /// Standard error of it, from the differences between the places that were tried; 0 where
  /// everything was tried, or only one place.
  double error = 0;
  std::size_t points = 0; ///< of the analysis
  std::size_t tried = 0;  ///< of these
  std::size_t failed = 0; ///< of these
  std::string reason{};   ///< why the first of them failed
  /// No place came to its end: the estimate goes by the share of a single motion that was tried,
  /// and is too high where that settles early.
  bool by_parts = false;
  /// A point was cut off without a word of how far it had come: the run will take more than that.
  bool at_least = false;
  bool memory_known = true; ///< Was a point tried to its end?
  double memory = 0; ///< of the results, all points as large as the largest that was tried [B]

  /// "about 0.35 s of computing on one core (0.3 to 0.4 s; 60 of 2008 points tried)"
  std::string sentence() const;
};

/// "0.35 s", "12 s", "28 min", "4.5 h", "42 days"
std::string duration_text(double seconds);

/// Tries short parts of the lines, spread evenly over all grid points and lines, as the run will
/// compute them, for at most `seconds` of processor time. A part begins with a point whose state
/// the next ones go on from; as often as a line begins anew, such a point counts. Local.
Cost estimate_cost(const std::vector<GridKey> &keys, const CaseFactory &factory, double seconds);

/// "5 modes from 2.95 Hz to 351.4 Hz, 3 points"
std::string body_sentence(const reduction::ReducedBody &body, bool dimensionless);

} // namespace vibroimpact::analyses
